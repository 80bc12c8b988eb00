#pragma once

#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "carom/simulation.hpp"

namespace carom::test {

/// One of the scenes that carom comes with, with one worker.
inline Scene scene_of(const char* name, Method method = Method::overlap) {
  Scene scene = read_scene(std::string(CAROM_SOURCE_DIR "/scenes/") + name + ".json");
  scene.solver.method = method;
  scene.workers = 1;
  return scene;
}

/// Its balls after some seconds.
inline std::vector<Ball> after(const Scene& scene, double time) {
  Simulation simulation(scene);
  simulation.advance_to(time);
  return simulation.state();
}

inline Vec2 total_momentum(const std::vector<Ball>& balls) {
  Vec2 sum{0, 0};
  for (const Ball& ball : balls) sum += ball.mass * ball.velocity;
  return sum;
}

}  // namespace carom::test
