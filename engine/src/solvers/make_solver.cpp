#include "solvers/make_solver.hpp"

#include <cstdlib>
#include <string_view>
#include <utility>

#include "solvers/solvers_of_build.hpp"

namespace carom {
namespace {

using MakeSolver = decltype(make_baseline_solver);

/// The solvers for the instructions that this processor has.
MakeSolver* solvers_of_processor() {
#ifdef CAROM_LEVELS
  const char* const wish = std::getenv("CAROM_SIMD");
  const std::string_view most = wish == nullptr ? "avx512" : wish;
  if (most == "baseline") return make_baseline_solver;
  if (most != "avx2" && __builtin_cpu_supports("x86-64-v4") != 0) return make_v4_solver;
  if (__builtin_cpu_supports("x86-64-v3") != 0) return make_v3_solver;
#endif
  return make_baseline_solver;
}

}  // namespace

std::unique_ptr<Solver> make_solver(const Scene& scene, std::vector<Ball> balls, Method method) {
  static MakeSolver* const kSolvers = solvers_of_processor();
  return kSolvers(scene, std::move(balls), method);
}

}  // namespace carom
