#pragma once

#include "carom/frame.hpp"
#include "view/camera.hpp"
#include "view/canvas.hpp"
#include "view/glyphs.hpp"

namespace carom {

/// Draws the balls of a frame as disks of pixels: a pixel whose middle lies within a ball is its.
/// Every ball has a pixel at least.  Fixed balls are hatched.
///
/// Blocks have one pixel across and two down in a cell, each with its own colour; braille two and
/// four, which share the colour of the ball that has most of them.
void paint_pixels(const Frame& frame, const Camera& camera, Glyphs glyphs, Canvas& canvas);

}  // namespace carom
