#include "solvers/event/make_core.hpp"

#include <algorithm>
#include <utility>

#include "solvers/event/fixed_disk_cells.hpp"
#include "solvers/event/loop_core.hpp"
#include "solvers/event/wide_physics.hpp"
#include "state/domain.hpp"

namespace carom::event {

namespace {

bool touches_wall(const Ball& ball, const Domain& domain) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double x = ball.position[axis];
    if (domain.solid(axis) &&
        (x == domain.lowest(axis, ball.radius) || x == domain.highest(axis, ball.radius))) {
      return true;
    }
  }
  return false;
}

bool touches_fixed(const Ball& ball, const FixedDiskCells& fixed, const Domain& domain) {
  return fixed.any_near(ball, [&](const Ball& other) {
    const double reach = (ball.radius + other.radius) * (1 + kTouching);
    return nearest_image(other.position - ball.position, domain).squaredNorm() <= reach * reach;
  });
}

}  // namespace

bool may_rest(const Scene& scene, const std::vector<Ball>& balls) {
  // Drag alone presses nothing together.
  if (scene.effects.drag && !scene.effects.gravity) return false;
  if (scene.continuation && scene.continuation->rests) return true;
  if (loses_energy(scene)) return true;
  if (!scene.effects.gravity) return false;
  if (scene.effects.drag) return true;  // it makes every bounce shorter
  const auto& friction = scene.effects.friction;
  if (friction && (friction->balls > 0 || friction->walls > 0)) return true;  // so does that
  // Without losses only what touches from the start can rest, and what fits exactly between walls.
  const Domain domain(scene.box, scene.effects.walls.has_value());
  const FixedDiskCells fixed(domain, balls);
  return std::any_of(balls.begin(), balls.end(), [&](const Ball& ball) {
    return !ball.fixed && (touches_wall(ball, domain) ||
                           (scene.effects.collisions && touches_fixed(ball, fixed, domain)));
  });
}

CoreInPrecision make_core(CoreStart start, int digits) {
  const auto made = [&]() -> std::unique_ptr<Core> {
    if (digits > kDigitsOfDouble) {
      const WidePrecision precision(digits);
      return std::make_unique<LoopCore<WidePhysics>>(std::move(start));
    }
    if (start.effects.drag) return std::make_unique<LoopCore<Drag>>(std::move(start));
    return std::make_unique<LoopCore<Ballistic>>(std::move(start));
  };
  return {made(), digits};
}

}  // namespace carom::event
