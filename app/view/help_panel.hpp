#pragma once

#include "view/canvas.hpp"
#include "view/glyphs.hpp"

namespace carom {

/// The pages that the help takes on a canvas of this size.
int help_pages(const Canvas& canvas);

/// Lays page `page` (from 0) of the help over the middle of the canvas: the keys in groups, in two
/// columns where there is room.
void paint_help(Canvas& canvas, int page, Glyphs glyphs);

}  // namespace carom
