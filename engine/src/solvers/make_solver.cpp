#include "solvers/make_solver.hpp"

#include <cstdlib>
#include <string_view>

#include "solvers/solvers_of_build.hpp"

namespace carom {
namespace {

#ifdef CAROM_AVX2
bool uses_avx2() {
  const char* const wish = std::getenv("CAROM_SIMD");
  if (wish != nullptr && std::string_view(wish) == "baseline") return false;
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
}
#endif

}  // namespace

std::unique_ptr<Solver> make_solver(const Scene& scene, const std::vector<Ball>& balls,
                                    Method method) {
#ifdef CAROM_AVX2
  static const bool kAvx2 = uses_avx2();
  if (kAvx2) return make_avx2_solver(scene, balls, method);
#endif
  return make_baseline_solver(scene, balls, method);
}

}  // namespace carom
