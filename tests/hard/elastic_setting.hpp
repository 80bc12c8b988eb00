#pragma once

#include "carom/scene.hpp"
#include "carom/simulation.hpp"

namespace carom {

inline Ball ball(double x, double y, double vx = 0, double vy = 0) {
  Ball result;
  result.position = {x, y};
  result.velocity = {vx, vy};
  return result;
}

/// Elastic balls in a box 10 high, under gravity, for one worker of method event.
inline Scene elastic_box(double width, const Vec2& gravity) {
  Scene scene;
  scene.box.width = width;
  scene.box.height = 10;
  scene.effects.walls = Walls{};
  scene.effects.collisions = Collisions{};
  scene.effects.gravity = Gravity{gravity};
  scene.solver.method = Method::event;
  scene.workers = 1;
  return scene;
}

inline Simulation at_time(const Scene& scene, double time) {
  Simulation run(scene);
  run.advance_to(time);
  return run;
}

}  // namespace carom
