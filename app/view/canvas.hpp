#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace carom {

/// What a cell shows: a palette gives each of these a look.
enum class Ink : unsigned char {
  none,
  wall,      ///< a solid side of the box
  periodic,  ///< a side that a ball leaves through to come in at the other
  open,      ///< a side that is not there: the scene has no walls
  ball,
  fixed,     ///< a ball that never moves
  status,    ///< plain text about the run
  notice,    ///< what a key just did, and the frames of panels
  ghost,     ///< where a ball would be, were it computed exactly
  trail,     ///< where a ball has been
  chosen,    ///< a selected line or ball
  computes,  ///< a worker's time spent computing
  waits      ///< a worker's time spent at a barrier
};

/// One character cell of a picture.
struct Cell {
  char32_t character = ' ';
  Ink ink = Ink::none;
  float heat = 0;        ///< of a ball: 0 still .. 1 fast
  Ink back = Ink::none;  ///< of a half-block: the ball of its other half
  float back_heat = 0;

  bool operator==(const Cell&) const = default;
};

/// A rectangle of cells, row 0 at the top.
struct Canvas {
  int columns = 0;
  int rows = 0;
  std::vector<Cell> cells;

  Canvas() = default;
  Canvas(int width, int height)
      : columns(width > 0 ? width : 0),
        rows(height > 0 ? height : 0),
        cells(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  [[nodiscard]] Cell& at(int column, int row) { return cells[index(column, row)]; }
  [[nodiscard]] const Cell& at(int column, int row) const { return cells[index(column, row)]; }
  [[nodiscard]] bool holds(int column, int row) const {
    return column >= 0 && column < columns && row >= 0 && row < rows;
  }

  /// Writes text from a cell to the right; what does not fit, or is not printable ASCII, is left
  /// out or shown as '?'.
  void write(int column, int row, std::string_view text, Ink ink);
  /// Puts one character, where the canvas has that cell.
  void put(int column, int row, char32_t character, Ink ink, float heat = 0);

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};

}  // namespace carom
