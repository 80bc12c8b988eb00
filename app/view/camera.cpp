#include "view/camera.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

Camera::Camera(const Box& box, int canvas_columns, int canvas_rows)
    : lower_(box.lower()), upper_(box.upper()), bordered_(canvas_columns >= 3 && canvas_rows >= 3) {
  const int border = bordered_ ? 2 : 0;
  const int room_across = std::max(1, canvas_columns - border);
  const int room_down = std::max(1, canvas_rows - border);
  // In units of a column's width the room is room_across by 2 * room_down.
  const double scale = std::min(room_across / box.width, 2.0 * room_down / box.height);
  columns_ = std::clamp(static_cast<int>(std::lround(box.width * scale)), 1, room_across);
  rows_ = std::clamp(static_cast<int>(std::lround(box.height * scale / 2)), 1, room_down);
  left_ = (canvas_columns - columns_) / 2;
  top_ = (canvas_rows - rows_) / 2;
  across_ = columns_ / box.width;
  down_ = rows_ / box.height;
}

}  // namespace carom
