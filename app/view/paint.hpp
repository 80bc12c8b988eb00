#pragma once

#include "carom/frame.hpp"
#include "view/canvas.hpp"

namespace carom {

/// Draws a frame into a canvas: pure, the same for `play` and for dumps.
void paint(const Frame& frame, Canvas& canvas);

}  // namespace carom
