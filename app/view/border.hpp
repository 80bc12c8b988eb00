#pragma once

#include "carom/frame.hpp"
#include "view/camera.hpp"
#include "view/canvas.hpp"
#include "view/glyphs.hpp"

namespace carom {

/// Draws the four sides of the box: solid, periodic or open, each different from the others.
void paint_border(const Frame& frame, const Camera& camera, Glyphs glyphs, Canvas& canvas);

}  // namespace carom
