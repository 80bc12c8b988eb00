#pragma once

#include <vector>

#include "solvers/event/solver.hpp"
#include "support/advance.hpp"

namespace carom::test {

/// A ball of mass 1.
inline Ball contact_ball(double x, double y, double vx = 0, double vy = 0, double radius = 0.5) {
  Ball result;
  result.position = {x, y};
  result.velocity = {vx, vy};
  result.radius = radius;
  return result;
}

inline Ball fixed_ball(double x, double y, double radius = 0.5) {
  Ball result = contact_ball(x, y, 0, 0, radius);
  result.fixed = true;
  return result;
}

/// A box with walls and balls of one restitution.
inline Scene contact_box(double width, double height, double restitution,
                         const Vec2& gravity = {0, -9.81}, int digits = 16) {
  Scene scene;
  scene.box.width = width;
  scene.box.height = height;
  scene.effects.walls = Walls{restitution};
  scene.effects.collisions = Collisions{restitution};
  scene.effects.gravity = Gravity{gravity};
  scene.solver.digits = digits;
  return scene;
}

struct ContactOutcome {
  std::vector<Ball> balls;
  double energy = 0;
  double energy_before = 0;
  double dissipated = 0;
  Measurements measured;
};

inline ContactOutcome run_contact(const Scene& scene, const std::vector<Ball>& balls, double time) {
  EventSolver solver(scene, balls);
  ContactOutcome outcome;
  outcome.energy_before = solver.energy();
  advance(solver, time);
  outcome.balls = solver.state();
  outcome.energy = solver.energy();
  outcome.dissipated = solver.dissipated();
  solver.count(outcome.measured);
  return outcome;
}

}  // namespace carom::test
