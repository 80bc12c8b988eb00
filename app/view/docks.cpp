#include "view/docks.hpp"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr int kRight = 44;  // their width
constexpr int kLeastDock = 7;
constexpr int kLeastStack = 16;  // of the instruments, above the cost panel
constexpr int kBorder = 2;

/// Rows that the box needs on so many columns, in its proportions.
int rows_of_box(const Box& box, int columns) {
  const double rows =
      std::ceil(std::max(1, columns - kBorder) * box.height / box.width / 2) + kBorder;
  return static_cast<int>(std::min(rows, 1e6));
}

}  // namespace

Docks docks_for(const DockWishes& wishes, const Box& box, int columns, int rows) {
  Docks docks;
  docks.box = {0, 0, columns, rows};
  const bool wide = columns >= kWideScreen;
  if (wide && (wishes.instruments > 0 || wishes.cost > 0)) {
    docks.box.columns -= kRight;
    int row = 0;
    const auto stack = [&](int wish, CellRect& place) {
      if (wish == 0 || rows - row < std::min(wish, kLeastDock)) return;
      place = {docks.box.columns, row, kRight, std::min(wish, rows - row)};
      row += place.rows;
    };
    const int for_cost = rows - wishes.cost >= kLeastStack ? wishes.cost : 0;
    stack(std::min(wishes.instruments, rows - for_cost), docks.instruments);
    stack(wishes.cost, docks.cost);
  }
  // Below: what the box leaves free in any case, and half of the screen at the most.
  const int most = std::max(rows - rows_of_box(box, docks.box.columns), rows / 2);
  int left = most;
  const auto below = [&](int wish, CellRect& place) {
    const int height = std::min(wish, left);
    if (wish == 0 || height < kLeastDock) return;
    left -= height;
    docks.box.rows -= height;
    place = {0, docks.box.rows, docks.box.columns, height};
  };
  const int instruments = wide ? 0 : wishes.instruments;
  if (wishes.threads_first) {
    below(wishes.threads, docks.threads);
    below(instruments, docks.instruments);
  } else {
    below(instruments, docks.instruments);
    below(wishes.threads, docks.threads);
  }
  return docks;
}

}  // namespace carom
