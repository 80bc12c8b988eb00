#pragma once

#include "carom/vector.hpp"

namespace carom {

/// One disk as the scene describes it.
struct Ball {
  Vec2 position{0, 0};
  Vec2 velocity{0, 0};
  double radius = 0.5;
  double mass = 1;
  double spin = 0;     ///< rad/s, counter-clockwise; kept only where the scene has friction
  bool fixed = false;  ///< never moves; has 1/mass = 0
  char glyph = 0;      ///< the character it is drawn with; 0: the painter's choice
};

}  // namespace carom
