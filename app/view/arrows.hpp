#pragma once

#include <vector>

#include "carom/ball.hpp"
#include "carom/frame.hpp"
#include "view/canvas.hpp"
#include "view/paint.hpp"

namespace carom {

/// Draws each ball's velocity as an arrow from its edge: as long as the way that it would fly in
/// one time, the same for all; of a ball of the typical speed that is a fifteenth of the
/// picture, or less where balls are close.
///
/// REQUIRES: the balls are those of the frame.
void paint_arrows(const Frame& frame, const std::vector<Ball>& balls, Canvas& canvas,
                  const Drawing& drawing);

}  // namespace carom
