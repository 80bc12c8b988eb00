#pragma once

#include <memory>
#include <vector>

#include "carom/scene.hpp"
#include "solvers/solver.hpp"

#ifndef CAROM_SOLVERS
#define CAROM_SOLVERS make_baseline_solver
#endif

namespace carom {

std::unique_ptr<Solver> make_baseline_solver(const Scene& scene, const std::vector<Ball>& balls,
                                             Method method);
/// There in a build with CAROM_AVX2 only.
std::unique_ptr<Solver> make_avx2_solver(const Scene& scene, const std::vector<Ball>& balls,
                                         Method method);

}  // namespace carom
