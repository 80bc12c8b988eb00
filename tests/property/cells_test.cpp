// Cells of a rectangle and the order by cell, held against what they say in plain loops.
#include "geometry/cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/random_numbers.hpp"

namespace carom::cells_test {
namespace {

/// Places of an axis that are one apart or the same, by trying all.
std::vector<Cells::Number> near_by_trial(const Cells& cells, std::size_t axis,
                                         Cells::Number place) {
  const auto count = static_cast<long>(cells.count(axis));
  std::vector<Cells::Number> near;
  for (long other = 0; other < count; ++other) {
    long apart = std::abs(other - static_cast<long>(place));
    if (cells.wraps(axis)) apart = std::min(apart, count - apart);
    if (apart <= 1) near.push_back(static_cast<Cells::Number>(other));
  }
  return near;
}

TEST(Cells, NamesEachCellAroundOnce) {
  for (const double count : {0.0, 1.0, 1.9, 2.0, 3.0, 4.0, 7.5}) {
    for (const bool wraps : {false, true}) {
      Cells cells;
      cells.divide(0, -1, 2, count, wraps);
      ASSERT_EQ(cells.count(0), std::max(1U, static_cast<unsigned>(count)));
      for (Cells::Number place = 0; place < cells.count(0); ++place) {
        const Cells::Near near = cells.near(0, place);
        std::vector<Cells::Number> got(near.begin(), near.end());
        std::sort(got.begin(), got.end());
        EXPECT_EQ(got, near_by_trial(cells, 0, place)) << count << " cells, " << wraps;
      }
    }
  }
}

TEST(Cells, PlacesNoFartherApartThanACellAreNear) {
  test::RandomNumbers random(7);
  for (int trial = 0; trial < 20'000; ++trial) {
    Cells cells;
    const double lower = random.between(-3, 3);
    const double length = random.between(0.1, 5);
    const double count = random.between(1, 9);
    cells.divide(1, lower, length, count, false);
    const double side = length / cells.count(1);
    // Beyond the ends too.
    const double x = random.between(lower - length, lower + 2 * length);
    const double y = x + random.between(-1, 1) * side * (1 - 0x1p-20);
    const std::vector<Cells::Number> near = near_by_trial(cells, 1, cells.along(1, x));
    EXPECT_NE(std::find(near.begin(), near.end(), cells.along(1, y)), near.end())
        << x << " and " << y << " from " << lower << " over " << length;
  }
}

TEST(ByCell, KeepsTheGivenOrderInEachCell) {
  test::RandomNumbers random(11);
  ByCell order;
  for (int trial = 0; trial < 300; ++trial) {
    const std::size_t cells = 1 + static_cast<std::size_t>(random.below(12));
    std::vector<std::uint32_t> cell(static_cast<std::size_t>(random.below(40)));
    for (std::uint32_t& c : cell)
      c = static_cast<std::uint32_t>(random.below(static_cast<int>(cells)));
    std::vector<std::size_t> expected(cell.size());
    for (std::size_t k = 0; k < cell.size(); ++k) expected[k] = k;
    std::stable_sort(expected.begin(), expected.end(),
                     [&](std::size_t a, std::size_t b) { return cell[a] < cell[b]; });
    std::vector<std::size_t> sorted(cell.size(), cell.size());
    order.sort(
        cells, cell.size(), [&](std::size_t k) { return cell[k]; },
        [&](std::size_t k, std::uint32_t at) { sorted[at] = k; });
    ASSERT_EQ(sorted, expected);
    for (std::size_t c = 0; c < cells; ++c) {
      ASSERT_EQ(order.end(c) - order.begin(c), std::count(cell.begin(), cell.end(), c));
      for (std::uint32_t at = order.begin(c); at < order.end(c); ++at) {
        ASSERT_EQ(cell[sorted[at]], c);
      }
    }
  }
}

}  // namespace
}  // namespace carom::cells_test
