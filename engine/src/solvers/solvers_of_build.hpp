#pragma once

#include <memory>
#include <vector>

#include "carom/scene.hpp"
#include "solvers/solver.hpp"

#ifndef CAROM_SOLVERS
#define CAROM_SOLVERS make_baseline_solver
#endif

namespace carom {

std::unique_ptr<Solver> make_baseline_solver(const Scene& scene, std::vector<Ball> balls,
                                             Method method);
/// There in a build with CAROM_LEVELS only: for processors of x86-64-v3 and x86-64-v4.
std::unique_ptr<Solver> make_v3_solver(const Scene& scene, std::vector<Ball> balls, Method method);
std::unique_ptr<Solver> make_v4_solver(const Scene& scene, std::vector<Ball> balls, Method method);

}  // namespace carom
