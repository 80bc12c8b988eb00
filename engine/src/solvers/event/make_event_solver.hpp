#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "carom/scene.hpp"
#include "solvers/solver.hpp"

namespace carom {

/// The exact method, compiled for the flights and the digits that the scene asks for.
std::unique_ptr<Solver> make_event_solver(const Scene& scene, std::vector<Ball> balls);

/// Memory of one ball's flight, with its spin where the scene has friction.
std::size_t event_flight_bytes(const Scene& scene);

}  // namespace carom
