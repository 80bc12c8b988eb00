#include "solvers/event/make_event_solver.hpp"

#include <utility>

#include "solvers/event/event_solver.hpp"

namespace carom {

std::unique_ptr<Solver> make_event_solver(const Scene& scene, std::vector<Ball> balls) {
  if (scene.effects.gravity) {
    return std::make_unique<EventSolver<event::Falling>>(scene, std::move(balls));
  }
  return std::make_unique<EventSolver<event::Free>>(scene, std::move(balls));
}

}  // namespace carom
