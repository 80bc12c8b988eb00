#pragma once

#include <array>
#include <vector>

#include "view/canvas.hpp"

namespace carom {

/// How much of a cell a disk covers, quarter by quarter: upper left, upper right, lower left,
/// lower right.
///
/// Units: samples, 0 to `kFull` in each quarter.
struct Coverage {
  static constexpr int kSamples = 8;  ///< along a side of a cell
  static constexpr int kFull = kSamples * kSamples / 4;

  std::array<int, 4> quarters{};

  [[nodiscard]] int total() const { return quarters[0] + quarters[1] + quarters[2] + quarters[3]; }
};

/// An axis-parallel ellipse among cells: a disk as the 1:2 cells see it.
struct Ellipse {
  double x = 0;
  double y = 0;
  double across = 0;  ///< half its width, columns
  double down = 0;    ///< half its height, rows
};

/// The cells [left, right) x [top, bottom).
struct CellRange {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// The cells of `clip` that the ellipse may touch; empty (right <= left) where there are none.
CellRange cells_of(const Ellipse& ellipse, const CellRange& clip);

/// The coverage of each cell of `range`, row by row, put into `coverage`.
void cover(const Ellipse& ellipse, const CellRange& range, std::vector<Coverage>& coverage);

/// The character whose ink lies most like the coverage; a blank where there is next to none.
char character_for(const Coverage& coverage);

}  // namespace carom
