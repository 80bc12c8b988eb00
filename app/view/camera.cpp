#include "view/camera.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

Camera::Camera(const Box& box, int canvas_columns, int canvas_rows, const Viewpoint& viewpoint)
    : lower_(box.lower()), upper_(box.upper()), bordered_(canvas_columns >= 3 && canvas_rows >= 3) {
  const int border = bordered_ ? 2 : 0;
  const int room_across = std::max(1, canvas_columns - border);
  const int room_down = std::max(1, canvas_rows - border);
  // In units of a column's width the room is room_across by 2 * room_down.
  const double scale = std::min(room_across / box.width, 2.0 * room_down / box.height);
  const bool near = viewpoint.zoom > Viewpoint::kFarthest;
  // A very flat box would reach far beyond any canvas: whole cells can still be counted.
  constexpr double kMostCells = 1e8;
  const double columns = box.width * scale * viewpoint.zoom;
  const double rows = box.height * scale * viewpoint.zoom / 2;
  columns_ = static_cast<int>(std::lround(std::min(columns, kMostCells)));
  rows_ = static_cast<int>(std::lround(std::min(rows, kMostCells)));
  columns_ = std::max(1, near ? columns_ : std::min(columns_, room_across));
  rows_ = std::max(1, near ? rows_ : std::min(rows_, room_down));
  const auto start = [near](int canvas, int size, double middle) {
    if (!near || size <= canvas) return (canvas - size) / 2;
    return static_cast<int>(std::lround(canvas / 2.0 - middle * size));
  };
  left_ = start(canvas_columns, columns_, viewpoint.x);
  top_ = start(canvas_rows, rows_, 1 - viewpoint.y);
  across_ = columns_ / box.width;
  down_ = rows_ / box.height;
}

}  // namespace carom
