#pragma once

#include "carom/scene.hpp"
#include "solvers/solver.hpp"

namespace carom {

/// Whether a ball can be added to a scene whose balls are where the solver has them.
/// Errors: CommandError where it has no mass or radius, or no room.
void check_room(const Ball& ball, const Scene& scene, const Solver& solver);

/// Whether effects can be changed so: walls cannot come back around balls that have left.
/// Errors: CommandError.
void check_inside(const Effects& change, const Scene& scene, const Solver& solver);

}  // namespace carom
