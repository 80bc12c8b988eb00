#include "solvers/event/domains/blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace carom::event::blocks_test {
namespace {

Domain domain(double width, double height, bool periodic) {
  Box box;
  box.width = width;
  box.height = height;
  box.periodic = {periodic, periodic};
  return {box, !periodic};
}

TEST(Blocks, HaveEachPlaceInOneOfThem) {
  const Blocks blocks(domain(20, 10, false), 2000);  // 200 blocks of side 1
  ASSERT_EQ(blocks.count(0), 20);
  ASSERT_EQ(blocks.count(1), 10);
  EXPECT_EQ(blocks.at(0.5, 0.5), 0U);
  EXPECT_EQ(blocks.at(19.5, 0.5), 19U);
  EXPECT_EQ(blocks.at(0.5, 1.5), 20U);
  EXPECT_EQ(blocks.at(19.5, 9.5), 199U);
  EXPECT_EQ(blocks.at(-3, 15), 180U);  // beyond ends that are walls: the outermost
  const Blocks around(domain(20, 10, true), 2000);
  EXPECT_EQ(around.at(-0.5, 10.5), 19U);
}

TEST(Blocks, AreCutIntoDomainsThatHaveEachBlockOnce) {
  for (const auto& [width, height] : std::vector<std::pair<double, double>>{{20, 10}, {3, 40}}) {
    const Blocks blocks(domain(width, height, false), 5000);
    for (const std::size_t wanted : {1U, 2U, 3U, 7U, 16U, 40U, 100000U}) {
      std::vector<int> times(blocks.all(), 0);
      const std::vector<BlockRange> ranges = cut(blocks, wanted);
      int least = blocks.count(0) * blocks.count(1);
      int most = 0;
      for (const BlockRange& range : ranges) {
        for (int y = 0; y < range.size[1]; ++y) {
          for (int x = 0; x < range.size[0]; ++x) {
            ++times[static_cast<std::size_t>((range.first[1] + y) * blocks.count(0) +
                                             range.first[0] + x)];
          }
        }
        least = std::min(least, range.size[0] * range.size[1]);
        most = std::max(most, range.size[0] * range.size[1]);
      }
      EXPECT_EQ(std::count(times.begin(), times.end(), 1),
                static_cast<std::ptrdiff_t>(blocks.all()));
      EXPECT_GE(ranges.size(), std::min(wanted, blocks.all()));
      EXPECT_GT(least, 0);
      if (wanted <= 16) {
        EXPECT_LE(most, 2 * least);
        EXPECT_LE(ranges.size(), 2 * wanted);
      }
    }
  }
}

}  // namespace
}  // namespace carom::event::blocks_test
