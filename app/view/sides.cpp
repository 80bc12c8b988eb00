#include "view/sides.hpp"

namespace carom {
namespace {

constexpr int kDotsApart = 4;  // columns; rows are twice as high, so half as many

struct Side {
  Cell cell;
  int every = 1;  // cells from mark to mark
};

Side side(const Frame& frame, std::size_t axis) {
  const bool upright = axis == 0;  // the sides that end the x axis stand upright
  if (frame.box.periodic[axis]) return {{upright ? ':' : '~', Ink::periodic, 0}, 1};
  if (frame.walls) return {{upright ? '|' : '-', Ink::wall, 0}, 1};
  return {{'.', Ink::open, 0}, upright ? kDotsApart / 2 : kDotsApart};
}

}  // namespace

void paint_sides(const Frame& frame, const Camera& camera, Canvas& canvas) {
  if (!camera.bordered()) return;
  const int left = camera.left() - 1;
  const int right = camera.left() + camera.columns();
  const int top = camera.top() - 1;
  const int bottom = camera.top() + camera.rows();
  const Side flat = side(frame, 1);
  const Side upright = side(frame, 0);
  // Counted from both ends at once, so that the marks are symmetric.
  for (int i = 0; 2 * i < camera.columns(); i += flat.every) {
    for (const int row : {top, bottom}) {
      canvas.at(left + 1 + i, row) = flat.cell;
      canvas.at(right - 1 - i, row) = flat.cell;
    }
  }
  for (int i = 0; 2 * i < camera.rows(); i += upright.every) {
    for (const int column : {left, right}) {
      canvas.at(column, top + 1 + i) = upright.cell;
      canvas.at(column, bottom - 1 - i) = upright.cell;
    }
  }
  const bool open = flat.cell.ink == Ink::open && upright.cell.ink == Ink::open;
  const Cell corner = {'+', open ? Ink::open : Ink::wall, 0};
  for (const int row : {top, bottom}) {
    canvas.at(left, row) = corner;
    canvas.at(right, row) = corner;
  }
}

}  // namespace carom
