#pragma once

#include <cstddef>
#include <vector>

#include "carom/scene.hpp"
#include "carom/vector.hpp"

namespace carom {

/// One ball as a frame shows it.
struct FrameBall {
  Vec2 position{0, 0};
  double radius = 0;
  double speed = 0;
  bool fixed = false;
  char glyph = 0;
};

/// What there is to see at one instant: a value that points back at nothing.
struct Frame {
  double time = 0;  ///< simulated seconds
  Box box;
  bool walls = false;  ///< the non-periodic sides are solid
  std::vector<FrameBall> balls;
};

}  // namespace carom
