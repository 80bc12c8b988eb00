#include "solvers/event/domains/slot_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace carom::event::slot_runs_test {
namespace {

struct Grid {
  int columns;
  int rows;
  bool wraps_x;
  bool wraps_y;
};

// Held against the cells that are around each, one by one.
TEST(SlotRuns, HaveTheBallsOfACellAndOfThoseAroundItOnce) {
  std::mt19937_64 random(9);
  const std::vector<Grid> grids{{7, 5, false, false}, {7, 5, true, false}, {3, 4, true, true},
                                {3, 3, false, true},  {1, 6, false, true}, {2, 1, false, false},
                                {1, 1, false, false}};
  for (const Grid& grid : grids) {
    Cells plane;
    plane.divide(0, 0, 1, grid.columns, grid.wraps_x);
    plane.divide(1, 0, 1, grid.rows, grid.wraps_y);
    std::vector<std::uint32_t> ends;
    std::vector<std::uint32_t> cell_of;
    for (std::uint32_t c = 0; c < plane.size(); ++c) {
      for (std::size_t k = random() % 4; k > 0; --k) cell_of.push_back(c);
      ends.push_back(static_cast<std::uint32_t>(cell_of.size()));
    }
    std::vector<int> visited(cell_of.size(), 0);
    each_cell_run(plane, ends, [&](const SlotRun& cell, std::span<const SlotRun> around) {
      ASSERT_LT(cell.first, cell.last);
      std::vector<std::uint32_t> found;
      for (const SlotRun& run : around) {
        for (std::uint32_t k = run.first; k < run.last; ++k) found.push_back(k);
      }
      std::sort(found.begin(), found.end());
      for (std::uint32_t i = cell.first; i < cell.last; ++i) {
        ++visited[i];
        EXPECT_EQ(cell_of[i], cell_of[cell.first]);
      }
      std::vector<std::uint32_t> wanted;
      plane.each_near(cell_of[cell.first], [&](std::uint32_t c) {
        for (std::uint32_t k = 0; k < cell_of.size(); ++k) {
          if (cell_of[k] == c) wanted.push_back(k);
        }
      });
      std::sort(wanted.begin(), wanted.end());
      EXPECT_EQ(found, wanted);
    });
    EXPECT_EQ(std::count(visited.begin(), visited.end(), 1),
              static_cast<std::ptrdiff_t>(visited.size()));
  }
}

}  // namespace
}  // namespace carom::event::slot_runs_test
