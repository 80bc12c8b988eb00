#include "solvers/event/make_event_solver.hpp"

#include <algorithm>
#include <utility>

#include "solvers/event/event_solver.hpp"
#include "solvers/event/settling_solver.hpp"
#include "solvers/event/wide_physics.hpp"
#include "state/domain.hpp"

namespace carom {
namespace {

template <class P>
std::unique_ptr<Solver> make(const Scene& scene, std::vector<Ball> balls) {
  if (scene.effects.friction) {
    return std::make_unique<EventSolver<typename event::RubbingOf<P>::Type>>(scene,
                                                                             std::move(balls));
  }
  return std::make_unique<EventSolver<P>>(scene, std::move(balls));
}

std::unique_ptr<Solver> make_settling(const Scene& scene, std::vector<Ball> balls) {
  if (scene.effects.friction) {
    return std::make_unique<SettlingSolver<event::DampedRubbing, event::DampedToRestRubbing>>(
        scene, std::move(balls));
  }
  return std::make_unique<SettlingSolver<event::Damped, event::DampedToRest>>(scene,
                                                                              std::move(balls));
}

// From the start: what is set while it runs is told by the script.
bool may_rest(const Scene& scene, const std::vector<Ball>& balls) {
  if (scene.continuation && scene.continuation->rests) return true;
  if (loses_energy(scene)) return true;
  if (!scene.effects.gravity) return false;
  const Vec2& g = scene.effects.gravity->acceleration;
  if (scene.effects.friction &&
      event::rubs_in_corners(scene.effects.friction->walls, {g.x(), g.y()})) {
    return true;
  }
  // Without losses only what lies still from the start rests, and what fits exactly between walls.
  const Domain domain(scene.box, scene.effects.walls.has_value());
  const auto lies = [&](const Ball& ball, std::size_t axis) {
    if (ball.fixed) return false;
    return ball.velocity.x() == 0 || ball.velocity.y() == 0 ||
           domain.lowest(axis, ball.radius) == domain.highest(axis, ball.radius);
  };
  return std::any_of(balls.begin(), balls.end(), [&](const Ball& ball) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double x = ball.position[static_cast<Eigen::Index>(axis)];
      if (domain.solid(axis) && lies(ball, axis) &&
          (x == domain.lowest(axis, ball.radius) || x == domain.highest(axis, ball.radius))) {
        return true;
      }
    }
    return false;
  });
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
  const bool falls = scene.effects.gravity.has_value();
  const bool rests = may_rest(scene, balls);
  if (scene.effects.drag) {
    if (falls && rests) return make<event::DampedToRest>(scene, std::move(balls));
    if (falls) return make_settling(scene, std::move(balls));
    return make<event::Damped>(scene, std::move(balls));
  }
  if (rests && falls) return make<event::FallingToRest>(scene, std::move(balls));
  if (rests) return make<event::FreeToRest>(scene, std::move(balls));
  if (falls) return make<event::Falling>(scene, std::move(balls));
  return make<event::Free>(scene, std::move(balls));
}

std::size_t event_flight_bytes(const Scene& scene) {
  const auto bytes = [&scene]<class P>(P*) {
    return scene.effects.friction ? sizeof(typename event::RubbingOf<P>::Type::Disk)
                                  : sizeof(typename P::Disk);
  };
  switch (scene.solver.digits) {
    case 34:
      return bytes(static_cast<event::Any34*>(nullptr));
    case 50:
      return bytes(static_cast<event::Any50*>(nullptr));
    case 100:
      return bytes(static_cast<event::Any100*>(nullptr));
    default:
      return bytes(static_cast<event::Free*>(nullptr));
  }
}

}  // namespace carom
