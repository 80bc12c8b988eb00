// Compiled once for each set of instructions; the second time CAROM_SOLVERS names its function.
#include "solvers/solvers_of_build.hpp"

#include <utility>

#include "solvers/event/solver.hpp"
#include "solvers/integrated/solver.hpp"
#include "solvers/overlap/solver.hpp"

namespace carom {

std::unique_ptr<Solver> CAROM_SOLVERS(const Scene& scene, std::vector<Ball> balls, Method method) {
  if (method == Method::event) {
    // Attraction leaves no closed-form flight: it is integrated.
    if (scene.effects.attraction) return std::make_unique<IntegratedSolver>(scene, balls);
    return std::make_unique<EventSolver>(scene, std::move(balls));
  }
  return std::make_unique<OverlapSolver>(scene, balls);
}

}  // namespace carom
