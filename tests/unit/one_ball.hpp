#pragma once

#include "carom/scene.hpp"

namespace carom {

/// A ball that flies to the right in an empty box.
inline Scene one_ball() {
  Scene scene;
  scene.name = "one";
  scene.effects.walls.emplace();
  scene.balls.push_back({{3, 5}, {2, 0}});
  return scene;
}

}  // namespace carom
