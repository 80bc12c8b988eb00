#pragma once

#include "carom/frame.hpp"
#include "view/camera.hpp"
#include "view/canvas.hpp"
#include "view/glyphs.hpp"

namespace carom {

/// How a frame is drawn.
struct Drawing {
  Glyphs glyphs = Glyphs::ascii;
  Viewpoint viewpoint;
};

/// Draws a frame into a canvas: pure, the same for `play` and for dumps.
///
/// Balls are disks true to their radius: each cell shows the character whose ink lies most like the
/// part that is covered; a ball smaller than a cell is one character.  A ball with a glyph is made
/// of it, a fixed one of '#'.  Solid sides are '-' and '|', periodic ones '~' and ':', and where
/// there are no walls a few dots.  Balls across a periodic side show on both.  With other glyphs
/// balls are disks of pixels or dots, and sides are lines.
void paint(const Frame& frame, Canvas& canvas, const Drawing& drawing = {});

}  // namespace carom
