#include "view/paint.hpp"

namespace carom {

void paint(const Frame& frame, Canvas& canvas) {
  const Vec2 lower = frame.box.lower();
  const Vec2 size = frame.box.size();
  for (const FrameBall& ball : frame.balls) {
    const int column =
        static_cast<int>((ball.position.x() - lower.x()) / size.x() * canvas.columns);
    const int row = canvas.rows - 1 -
                    static_cast<int>((ball.position.y() - lower.y()) / size.y() * canvas.rows);
    if (column < 0 || column >= canvas.columns || row < 0 || row >= canvas.rows) continue;
    canvas.at(column, row).character = 'o';
  }
}

}  // namespace carom
