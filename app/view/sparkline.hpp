#pragma once

#include <vector>

#include "view/canvas.hpp"
#include "view/glyphs.hpp"

namespace carom {

/// A row of characters whose heights are values: a curve in one line.  The lowest value stands at
/// the bottom and the highest at the top; where all are equal the line is level.
Canvas sparkline(const std::vector<double>& values, int columns, Glyphs glyphs);

}  // namespace carom
