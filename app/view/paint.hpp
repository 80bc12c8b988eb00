#pragma once

#include "carom/frame.hpp"
#include "view/canvas.hpp"

namespace carom {

/// Draws a frame into a canvas: pure, the same for `play` and for dumps.
///
/// Balls are disks true to their radius: each cell shows the character whose ink lies most like the
/// part that is covered; a ball smaller than a cell is one character.  A ball with a glyph is made
/// of it, a fixed one of '#'.  Solid sides are '-' and '|', periodic ones '~' and ':', and where
/// there are no walls a few dots.  Balls across a periodic side show on both.
void paint(const Frame& frame, Canvas& canvas);

}  // namespace carom
