#include "view/aim.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace carom {

void paint_aim(const Aim& aim, Canvas& canvas) {
  const int across = aim.to_column - aim.column;
  const int down = aim.to_row - aim.row;
  const int cells = std::max(std::abs(across), std::abs(down));
  for (int i = 1; i <= cells; ++i) {
    const double part = static_cast<double>(i) / cells;
    canvas.put(aim.column + static_cast<int>(std::lround(across * part)),
               aim.row + static_cast<int>(std::lround(down * part)), i == cells ? U'*' : U'.',
               Ink::notice);
  }
  canvas.put(aim.column, aim.row, U'o', Ink::notice);
}

}  // namespace carom
