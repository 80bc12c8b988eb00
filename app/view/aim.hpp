#pragma once

#include "view/canvas.hpp"

namespace carom {

/// A ball about to be thrown: where the pointer went down, and where it is.
struct Aim {
  int column = 0;
  int row = 0;
  int to_column = 0;
  int to_row = 0;

  [[nodiscard]] bool still() const { return column == to_column && row == to_row; }
};

/// Draws the way that the ball is thrown.
void paint_aim(const Aim& aim, Canvas& canvas);

}  // namespace carom
