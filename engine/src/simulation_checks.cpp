#include "simulation_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "carom/shorter_way.hpp"
#include "carom/simulation.hpp"
#include "state/domain.hpp"

namespace carom {
namespace {

void check_values(const Ball& ball) {
  if (!(ball.radius > 0) || !(ball.mass > 0) || !std::isfinite(ball.radius) ||
      !std::isfinite(ball.mass) || !ball.position.allFinite() || !ball.velocity.allFinite() ||
      !std::isfinite(ball.spin)) {
    throw CommandError("a ball needs a position, a velocity, a radius and a mass above 0");
  }
}

void check_walls(const Ball& ball, const Scene& scene) {
  const Domain domain(scene.box, has_walls(scene.effects));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double x = ball.position[axis];
    const bool outside =
        x < domain.lower[axis] + ball.radius || x > domain.upper[axis] - ball.radius;
    if (domain.solid(axis) && outside) {
      throw CommandError(fmt::format("a ball at ({}, {}) would stick out of the box",
                                     ball.position.x(), ball.position.y()));
    }
  }
}

}  // namespace

void check_room(const Ball& ball, const Scene& scene, const Solver& solver) {
  check_values(ball);
  check_walls(ball, scene);
  if (!has_collisions(scene.effects)) return;
  const std::vector<Ball> balls = solver.state();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (ball.fixed && balls[i].fixed) continue;
    const Vec2 r = shorter_way(balls[i].position - ball.position, scene.box);
    const double reach = balls[i].radius + ball.radius;
    if (r.squaredNorm() < reach * reach) {
      throw CommandError(fmt::format("a ball at ({}, {}) would overlap ball {}", ball.position.x(),
                                     ball.position.y(), i));
    }
  }
}

void check_inside(const Effects& change, const Scene& scene, const Solver& solver) {
  if (!has_walls(change) || has_walls(scene.effects)) return;
  const Domain domain(scene.box, true);
  const std::vector<Ball> balls = solver.state();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double x = balls[i].position[axis];
      if (!domain.solid(axis) || (x >= domain.lower[axis] && x <= domain.upper[axis])) continue;
      throw CommandError(fmt::format("walls stay off: ball {} is out of the box", i));
    }
  }
}

}  // namespace carom
