#pragma once

#include <cstddef>
#include <optional>

#include "carom/frame.hpp"
#include "view/camera.hpp"

namespace carom {

/// The point of the scene in the middle of a cell.
Vec2 point_at(const Camera& camera, int column, int row);

/// The ball of the frame that a pointer at this cell means: one that covers its middle or lies at
/// its edge, of several the one whose own middle is nearest for its size.
std::optional<std::size_t> ball_at(const Frame& frame, const Camera& camera, int column, int row);

/// The viewpoint that is `factor` times as near and has the same point of the scene at a cell.
Viewpoint zoomed_at(const Box& box, int columns, int rows, const Viewpoint& view, double factor,
                    int column, int row);

}  // namespace carom
