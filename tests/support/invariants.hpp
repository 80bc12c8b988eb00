#pragma once

#include <string>

#include "carom/scene.hpp"

namespace carom::test {

/// Runs the scene for its duration, and again by other ways that must end with the same bits:
/// other workers, frame rates, units, orders of the balls, mirrors, and stopped, saved and gone on.
/// Gives the first invariant that does not hold, and how; empty: all hold.
std::string broken_invariant(const Scene& scene);

}  // namespace carom::test
