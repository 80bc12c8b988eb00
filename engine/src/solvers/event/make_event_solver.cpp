#include "solvers/event/make_event_solver.hpp"

#include <utility>

#include "solvers/event/event_solver.hpp"
#include "solvers/event/wide_physics.hpp"

namespace carom {
namespace {

template <class P>
std::unique_ptr<Solver> make(const Scene& scene, std::vector<Ball> balls) {
  return std::make_unique<EventSolver<P>>(scene, std::move(balls));
}

}  // namespace

std::unique_ptr<Solver> make_event_solver(const Scene& scene, std::vector<Ball> balls) {
  switch (scene.solver.digits) {
    case 34:
      return make<event::Any34>(scene, std::move(balls));
    case 50:
      return make<event::Any50>(scene, std::move(balls));
    case 100:
      return make<event::Any100>(scene, std::move(balls));
    default:
      break;
  }
  if (scene.effects.drag) return make<event::Damped>(scene, std::move(balls));
  if (scene.effects.gravity) return make<event::Falling>(scene, std::move(balls));
  return make<event::Free>(scene, std::move(balls));
}

std::size_t event_flight_bytes(int digits) {
  switch (digits) {
    case 34:
      return sizeof(event::Any34::Disk);
    case 50:
      return sizeof(event::Any50::Disk);
    case 100:
      return sizeof(event::Any100::Disk);
    default:
      return sizeof(event::Disk);
  }
}

}  // namespace carom
