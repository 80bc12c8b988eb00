#pragma once

#include "carom/frame.hpp"
#include "view/camera.hpp"
#include "view/canvas.hpp"

namespace carom {

/// Draws the four sides of the box: solid, periodic or open, each different from the others.
void paint_sides(const Frame& frame, const Camera& camera, Canvas& canvas);

}  // namespace carom
