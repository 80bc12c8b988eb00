#pragma once

#include <memory>
#include <vector>

#include "carom/scene.hpp"
#include "solvers/solver.hpp"

namespace carom {

/// The solver of a scene by a method that can take it.
///
/// A build for any processor of x86-64 holds the solvers twice, the second time for processors with
/// AVX2, and chooses here.  Both compute the same bits.  CAROM_SIMD=baseline in the environment
/// chooses the first.
std::unique_ptr<Solver> make_solver(const Scene& scene, const std::vector<Ball>& balls,
                                    Method method);

}  // namespace carom
