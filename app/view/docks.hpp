#pragma once

#include "carom/scene.hpp"

namespace carom {

/// A rectangle of cells.
struct CellRect {
  int column = 0;
  int row = 0;
  int columns = 0;
  int rows = 0;

  [[nodiscard]] bool empty() const { return columns <= 0 || rows <= 0; }
};

/// What is to be shown beside the box: the rows that each panel wants, 0 where it is closed.
struct DockWishes {
  int threads = 0;
  int instruments = 0;
  int cost = 0;
  bool threads_first = false;  ///< where there is no room for both below the box
};

/// Where the box and the panels stand on a screen.  The box keeps the upper left corner, more
/// than half of the columns and half of the rows, or as many as it needs; a panel without room is
/// empty.
///
/// Instruments and cost stack at the right where the screen is wide, the threads stand below the
/// box, and so do the instruments where it is narrow.  A cost panel that has no place here is laid
/// over the box.
struct Docks {
  CellRect box;
  CellRect threads;
  CellRect instruments;
  CellRect cost;
};

/// From so many columns on there are panels at the right.
inline constexpr int kWideScreen = 96;

Docks docks_for(const DockWishes& wishes, const Box& box, int columns, int rows);

}  // namespace carom
