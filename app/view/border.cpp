#include "view/border.hpp"

#include <algorithm>
#include <array>

namespace carom {
namespace {

constexpr int kDotsApart = 4;  // columns; rows are twice as high, so half as many

struct SideLook {
  char32_t character;
  Ink ink;
  int every = 1;  // cells from mark to mark
};

SideLook side(const Frame& frame, std::size_t axis, Glyphs glyphs) {
  const bool upright = axis == 0;  // the sides that end the x axis stand upright
  const bool ascii = glyphs == Glyphs::ascii;
  if (frame.box.periodic[axis]) {
    if (ascii) return {upright ? U':' : U'~', Ink::periodic};
    return {upright ? U'┆' : U'┄', Ink::periodic};
  }
  if (frame.walls) {
    if (ascii) return {upright ? U'|' : U'-', Ink::wall};
    return {upright ? U'│' : U'─', Ink::wall};
  }
  return {ascii ? U'.' : U'·', Ink::open, upright ? kDotsApart / 2 : kDotsApart};
}

}  // namespace

void paint_border(const Frame& frame, const Camera& camera, Glyphs glyphs, Canvas& canvas) {
  if (!camera.bordered()) return;
  const int left = camera.left() - 1;
  const int right = camera.left() + camera.columns();
  const int top = camera.top() - 1;
  const int bottom = camera.top() + camera.rows();
  const SideLook flat = side(frame, 1, glyphs);
  const SideLook upright = side(frame, 0, glyphs);
  const auto put = [&canvas](int column, int row, const SideLook& mark) {
    canvas.put(column, row, mark.character, mark.ink);
  };
  // Counted from both ends at once, so that the marks are symmetric.  Only those on the canvas.
  const auto each_mark = [](int count, int every, int before, int room, const auto& mark) {
    const int end = std::min(room, before + count);
    for (int at = std::max(0, before); at < end; ++at) {
      const int from_start = at - before;
      if (std::min(from_start, count - 1 - from_start) % every == 0) mark(at);
    }
  };
  each_mark(camera.columns(), flat.every, left + 1, canvas.columns, [&](int column) {
    put(column, top, flat);
    put(column, bottom, flat);
  });
  each_mark(camera.rows(), upright.every, top + 1, canvas.rows, [&](int row) {
    put(left, row, upright);
    put(right, row, upright);
  });
  const bool open = flat.ink == Ink::open && upright.ink == Ink::open;
  const bool ascii = glyphs == Glyphs::ascii;
  const std::array<char32_t, 4> corners = ascii ? std::array<char32_t, 4>{U'+', U'+', U'+', U'+'}
                                                : std::array<char32_t, 4>{U'┌', U'┐', U'└', U'┘'};
  const Ink ink = open ? Ink::open : Ink::wall;
  canvas.put(left, top, corners[0], ink);
  canvas.put(right, top, corners[1], ink);
  canvas.put(left, bottom, corners[2], ink);
  canvas.put(right, bottom, corners[3], ink);
}

}  // namespace carom
