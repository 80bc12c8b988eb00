#include "view/pointer.hpp"

#include <algorithm>
#include <cmath>

#include "view/ball_images.hpp"

namespace carom {
namespace {

constexpr double kMiddle = 0.5;  // of a cell, from its corner
constexpr double kReach = 0.5;   // cells around a ball that are still the ball

}  // namespace

Vec2 point_at(const Camera& camera, int column, int row) {
  return {camera.scene_x(column + kMiddle), camera.scene_y(row + kMiddle)};
}

std::optional<std::size_t> ball_at(const Frame& frame, const Camera& camera, int column, int row) {
  std::optional<std::size_t> found;
  double nearest = 1;
  for (std::size_t i = 0; i < frame.balls.size(); ++i) {
    each_image(frame, camera, frame.balls[i], [&](const Ellipse& ellipse) {
      const double x = (column + kMiddle - ellipse.x) / (ellipse.across + kReach);
      const double y = (row + kMiddle - ellipse.y) / (ellipse.down + kReach);
      const double distance = std::hypot(x, y);
      if (distance > nearest) return;
      nearest = distance;
      found = i;
    });
  }
  return found;
}

Viewpoint zoomed_at(const Box& box, int columns, int rows, const Viewpoint& view, double factor,
                    int column, int row) {
  Viewpoint next = view;
  next.zoom = std::clamp(view.zoom * factor, Viewpoint::kFarthest, Viewpoint::kNearest);
  if (next.zoom == Viewpoint::kFarthest) return {};
  const Vec2 point = point_at(Camera(box, columns, rows, view), column, row);
  const Camera near(box, columns, rows, next);
  const Vec2 part{(point.x() - box.lower().x()) / box.width,
                  (point.y() - box.lower().y()) / box.height};
  next.x = std::clamp(part.x() + (columns / 2.0 - column - kMiddle) / near.columns(), 0.0, 1.0);
  next.y = std::clamp(part.y() - (rows / 2.0 - row - kMiddle) / near.rows(), 0.0, 1.0);
  return next;
}

}  // namespace carom
