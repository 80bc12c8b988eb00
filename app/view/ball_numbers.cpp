#include "view/ball_numbers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "view/ball_images.hpp"
#include "view/camera.hpp"

namespace carom {

void paint_numbers(const Frame& frame, const std::vector<std::size_t>& numbers, Canvas& canvas,
                   const Drawing& drawing) {
  if (numbers.size() != frame.balls.size()) return;
  const Camera camera(frame.box, canvas.columns, canvas.rows, drawing.viewpoint);
  const CellRange cells = visible_cells(frame, camera, canvas);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string number = fmt::format("{}", numbers[i]);
    const auto size = static_cast<double>(number.size());
    each_image(frame, camera, frame.balls[i], [&](const Ellipse& ellipse) {
      if (2 * ellipse.across < size + 2 || 2 * ellipse.down < 2) return;
      const double column = std::round(ellipse.x - size / 2);
      const double row = std::floor(ellipse.y);
      if (column >= cells.left && column + size <= cells.right && row >= cells.top &&
          row < cells.bottom)
        canvas.write(static_cast<int>(column), static_cast<int>(row), number, Ink::chosen);
    });
  }
}

}  // namespace carom
