#pragma once

#include <memory>
#include <vector>

#include "carom/scene.hpp"
#include "solvers/solver.hpp"

namespace carom {

/// The exact method, compiled for the flights and the digits that the scene asks for.
std::unique_ptr<Solver> make_event_solver(const Scene& scene, std::vector<Ball> balls);

}  // namespace carom
