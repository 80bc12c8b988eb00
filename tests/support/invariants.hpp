#pragma once

#include <string>

#include "carom/scene.hpp"

namespace carom::test {

/// What must hold of every run, tried on one scene.
struct Verdict {
  std::string broken;    ///< the first invariant that does not hold, and how; empty: all hold
  std::string left_out;  ///< why some are not tried; empty: all are
};

/// Runs the scene for its duration, and again by other ways that must end with the same bits:
/// other workers, frame rates, units, orders of the balls, mirrors, and stopped, saved and gone on.
Verdict try_invariants(const Scene& scene);

}  // namespace carom::test
