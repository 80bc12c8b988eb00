#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/cells.hpp"

namespace carom::event {

/// Balls numbered by cell, next to each other: [first, last).
struct SlotRun {
  std::uint32_t first;
  std::uint32_t last;
};

/// Calls visit(run, around) for each cell that has balls: those in it, and the runs of those in it
/// and in the cells around it, each once.  `ends`: of each cell, where its numbers end and those of
/// the next one begin.
/// REQUIRES: along an axis that wraps round there are three cells at least.
template <class Visit>
[[gnu::always_inline]] inline void each_cell_run(const Cells& plane,
                                                 const std::vector<std::uint32_t>& ends,
                                                 const Visit& visit) {
  const auto begin_of = [&](int c) { return c == 0 ? 0U : ends[static_cast<std::size_t>(c) - 1]; };
  const auto end_of = [&](int c) { return ends[static_cast<std::size_t>(c)]; };
  const int columns = static_cast<int>(plane.count(0));
  const int rows = static_cast<int>(plane.count(1));
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const int c = y * columns + x;
      if (begin_of(c) == end_of(c)) continue;
      std::array<SlotRun, 6> runs;
      std::size_t count = 0;
      for (int row = y - 1; row <= y + 1; ++row) {
        if ((row < 0 || row == rows) && !plane.wraps(1)) continue;
        const int first = (row < 0 ? rows - 1 : row == rows ? 0 : row) * columns;
        const int last = first + columns - 1;
        runs[count++] = {begin_of(std::max(first + x - 1, first)),
                         end_of(std::min(first + x + 1, last))};
        if (!plane.wraps(0)) continue;
        if (x == 0) runs[count++] = {begin_of(last), end_of(last)};
        if (x + 1 == columns) runs[count++] = {begin_of(first), end_of(first)};
      }
      visit(SlotRun{begin_of(c), end_of(c)}, std::span<const SlotRun>(runs.data(), count));
    }
  }
}

}  // namespace carom::event
