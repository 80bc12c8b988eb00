#pragma once

#include <memory>
#include <vector>

#include "carom/scene.hpp"
#include "solvers/solver.hpp"

namespace carom {

/// The solver of a scene by a method that can take it.
///
/// A build for any processor of x86-64 holds the solvers three times: for every processor, for
/// those with AVX2 and for those with AVX-512, and chooses here.  All compute the same bits.
/// CAROM_SIMD in the environment, baseline or avx2, limits the choice.
std::unique_ptr<Solver> make_solver(const Scene& scene, std::vector<Ball> balls, Method method);

}  // namespace carom
