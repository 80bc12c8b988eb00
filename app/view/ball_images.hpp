#pragma once

#include <algorithm>
#include <cmath>

#include "carom/frame.hpp"
#include "view/camera.hpp"
#include "view/canvas.hpp"
#include "view/disk.hpp"

namespace carom {

/// The cells of a canvas in which balls may be seen: only where there is no side can one be seen
/// beyond it.
inline CellRange visible_cells(const Frame& frame, const Camera& camera, const Canvas& canvas) {
  CellRange cells{0, 0, canvas.columns, canvas.rows};
  if (frame.walls || frame.box.periodic[0]) {
    cells.left = std::clamp(camera.left(), 0, canvas.columns);
    cells.right = std::clamp(camera.left() + camera.columns(), 0, canvas.columns);
  }
  if (frame.walls || frame.box.periodic[1]) {
    cells.top = std::clamp(camera.top(), 0, canvas.rows);
    cells.bottom = std::clamp(camera.top() + camera.rows(), 0, canvas.rows);
  }
  return cells;
}

/// Calls `draw` with the ellipse of the ball among the cells and, on a periodic axis, with those of
/// its images next to the box.
template <class Draw>
void each_image(const Frame& frame, const Camera& camera, const FrameBall& ball, Draw&& draw) {
  const Vec2 lower = frame.box.lower();
  const Vec2 size = frame.box.size();
  Vec2 home = ball.position;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (frame.box.periodic[axis])
      home[axis] -= size[axis] * std::floor((home[axis] - lower[axis]) / size[axis]);
  }
  const int beside = frame.box.periodic[0] ? 1 : 0;
  const int above = frame.box.periodic[1] ? 1 : 0;
  for (int i = -beside; i <= beside; ++i) {
    for (int j = -above; j <= above; ++j) {
      draw(Ellipse{camera.x(home.x() + i * size.x()), camera.y(home.y() + j * size.y()),
                   ball.radius * camera.across(), ball.radius * camera.down()});
    }
  }
}

/// The root mean square speed of the balls that can move.
double typical_speed(const std::vector<FrameBall>& balls);

/// How fast a ball is beside the others: 0 still .. 1 at least twice as fast as is typical.
inline float heat_of(const FrameBall& ball, double typical) {
  return typical > 0 ? static_cast<float>(std::min(1.0, ball.speed / (2 * typical))) : 0.F;
}

}  // namespace carom
