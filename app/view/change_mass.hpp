#pragma once

#include <cstddef>
#include <string>

#include "carom/session.hpp"

namespace carom {

/// Gives a ball of the session another mass: it leaves, and comes back as the newest ball at the
/// same place and as fast.
///
/// Says why not where it cannot come back, because it touches something; nothing has changed then.
std::string change_mass(Session& session, std::size_t ball, double factor);

}  // namespace carom
