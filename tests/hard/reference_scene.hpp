#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "carom/scene.hpp"

namespace carom::test {

/// A scene with its exact end, which an independent program found in 100-digit arithmetic.
struct ReferenceScene {
  Scene scene;
  double time;
  double condition;         ///< how much the flow amplifies a small change of the start
  nlohmann::json expected;  ///< ball_ball, ball_wall, balls [{position, velocity}] as texts

  [[nodiscard]] double size() const { return std::max(scene.box.width, scene.box.height); }
};

ReferenceScene reference_scene(const std::string& name);

}  // namespace carom::test
