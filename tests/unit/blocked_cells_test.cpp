#include "fill/blocked_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <tuple>
#include <vector>

#include "support/scenes.hpp"

namespace carom::scene::blocked_cells_test {
namespace {

// Places are looked at one by one: those that are blocked lie in the circle of some disk, and so
// does nearly every place of the middle of a circle.
TEST(BlockedCells, BlockWhatOverlapsAndNothingElse) {
  const Vec2 lower{-30, 2};
  const Vec2 upper{20, 42};
  const double radius = 0.5;
  BlockedCells cells(lower, upper, radius, 2000, 50);
  std::mt19937_64 engine(3);
  const auto drawn = [&] {
    return Vec2{lower.x() + 50 * test::uniform(engine), lower.y() + 40 * test::uniform(engine)};
  };
  struct Disk {
    Vec2 position;
    double radius;
  };
  std::vector<Disk> disks;
  for (int k = 0; k < 300; ++k) {
    disks.push_back({drawn(), k % 3 == 0 ? 0.75 : 0.25});
    cells.insert(disks.back().position, disks.back().radius);
  }
  disks.push_back({{-31, 20}, 2});  // one that reaches in from outside
  cells.insert(disks.back().position, disks.back().radius);
  std::size_t blocked = 0;
  std::size_t inner = 0;
  for (int k = 0; k < 100000; ++k) {
    const Vec2 place = drawn();
    double depth = -1;
    for (const Disk& disk : disks) {
      depth = std::max(depth, radius + disk.radius - (place - disk.position).norm());
    }
    const bool is_blocked = cells.blocked(place);
    if (is_blocked) {
      ++blocked;
      EXPECT_GT(depth, 0);
    }
    // Deeper than the diagonal of a cell is surely in a cell that lies in the circle.
    if (depth > 0.5 * radius * std::sqrt(2.0) + 0.01) {
      ++inner;
      EXPECT_TRUE(is_blocked);
    }
  }
  EXPECT_GT(inner, 10000U);
  EXPECT_GT(blocked, inner);
}

TEST(BlockedCells, AreNotThereWhereTheyDoNotPay) {
  const Vec2 lower{0, 0};
  for (const auto& [size, count, farthest] :
       {std::tuple{10.0, 10, 10.0}, std::tuple{1e4, 2000, 1e4}, std::tuple{40.0, 2000, 1e12}}) {
    BlockedCells cells(lower, {size, size}, 0.5, static_cast<std::size_t>(count), farthest);
    cells.insert({size / 2, size / 2}, 0.5);
    EXPECT_FALSE(cells.blocked({size / 2, size / 2})) << size;
  }
  BlockedCells cells(lower, {40, 40}, 0.5, 2000, 40);
  cells.insert({20, 20}, 0.5);
  EXPECT_TRUE(cells.blocked({20, 20}));
}

}  // namespace
}  // namespace carom::scene::blocked_cells_test
