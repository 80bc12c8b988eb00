#pragma once

#include <vector>

#include "contact/impulse_guess.hpp"

namespace carom::event {

/// Which contacts carry an impulse where all that push part at least with speed 0, those that carry
/// one with just that, as do those that hold: `give`, `may` and `parting` as in guess_impulses().
///
/// It takes about twenty factorisations, however many of the contacts carry nothing.
/// REQUIRES: give > 0.
/// Source: Mehrotra, SIAM J. Optim. 2 (1992) 575, for a quadratic function.
[[nodiscard]] std::vector<char> carrying_contacts(const ResponseMatrix& response,
                                                  const std::vector<double>& parting,
                                                  const std::vector<char>& may, double give);

}  // namespace carom::event
