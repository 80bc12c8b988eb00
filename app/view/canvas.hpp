#pragma once

#include <string>
#include <vector>

namespace carom {

/// One character cell of a picture.
struct Cell {
  char character = ' ';
  double heat = 0;  ///< 0 slow .. 1 fast; colours it where the screen has colours
};

/// A rectangle of cells, row 0 at the top.
struct Canvas {
  int columns = 0;
  int rows = 0;
  std::vector<Cell> cells;

  Canvas(int width, int height)
      : columns(width), rows(height), cells(static_cast<std::size_t>(width * height)) {}
  [[nodiscard]] Cell& at(int column, int row) {
    return cells[static_cast<std::size_t>(row * columns + column)];
  }
  [[nodiscard]] const Cell& at(int column, int row) const {
    return cells[static_cast<std::size_t>(row * columns + column)];
  }
};

}  // namespace carom
