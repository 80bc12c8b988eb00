#pragma once

#include <cstddef>
#include <vector>

#include "carom/frame.hpp"
#include "view/canvas.hpp"
#include "view/paint.hpp"

namespace carom {

/// Writes the number of each ball over its middle, where the ball is wide enough to hold it.
///
/// REQUIRES: a number for each ball of the frame.
void paint_numbers(const Frame& frame, const std::vector<std::size_t>& numbers, Canvas& canvas,
                   const Drawing& drawing);

}  // namespace carom
