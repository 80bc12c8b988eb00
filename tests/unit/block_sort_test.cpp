#include "solvers/event/domains/block_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "solvers/event/physics.hpp"
#include "support/flight_at.hpp"

namespace carom::event::block_sort_test {
namespace {

/// Balls of radius 0.1, in a box of 20 by 10; those of the second species are larger.
Rules box_rules(double gravity) {
  Box box;
  box.width = 20;
  box.height = 10;
  Rules rules{{box, true}, FixedTimeClock(0.5)};
  rules.all_species = {{0.1, 1}, {0.3, 1}};
  rules.gravity = {0, gravity};
  return rules;
}

struct Sorting {
  Motion<Ballistic> motion;
  Blocks blocks{motion.rules().domain, 1000};
  BlockSort<Ballistic> sort;
  HugeVector<BlockFlight> flights;
  HugeVector<BlockFlight> sorted;
  std::size_t workers;

  Sorting(double gravity, std::size_t count) : motion(box_rules(gravity)), workers(count) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> part(0, 1);
    for (Index k = 0; k < 1000; ++k) {
      const Disk disk = flight_at(18 * part(random) + 1, 8 * part(random) + 1, 3 * part(random),
                                  3 * part(random) - 1, k % 50 == 7 ? 1 : 0);
      flights.push_back(BlockFlight::of(disk, k));
    }
    sort.reset(blocks, count);
    sort.make_room(flights.size());
    sorted.resize(flights.size());
  }
  void run(FixedTime now) {
    for (std::size_t w = 0; w < workers; ++w)
      sort.count(motion, blocks, flights, now, {w, workers});
    sort.place_blocks();
    for (std::size_t w = 0; w < workers; ++w) {
      sort.scatter(flights.size(), {w, workers},
                   [this](std::size_t k, Index at) { sorted[at] = flights[k]; });
    }
  }
  /// Of a flight at this time.
  [[nodiscard]] Index block(const BlockFlight& flight, FixedTime now) const {
    const Vec<double> at = motion.place(flight, now);
    return blocks.at(at.x, at.y);
  }
};

TEST(BlockSort, PutsEachFlightIntoTheBlockItIsIn) {
  for (const double gravity : {0.0, -4.0}) {
    Sorting all(gravity, 3);
    const FixedTime now = all.motion.rules().scale.ticks(0.25);
    all.run(now);
    std::vector<int> found(all.flights.size(), 0);
    const std::vector<Index>& starts = all.sort.starts();
    ASSERT_EQ(starts.size(), all.blocks.all() + 1);
    EXPECT_EQ(starts.back(), all.flights.size());
    for (std::size_t b = 0; b < all.blocks.all(); ++b) {
      for (Index k = starts[b]; k < starts[b + 1]; ++k) {
        EXPECT_EQ(all.block(all.sorted[k], now), b);
        EXPECT_TRUE(k == starts[b] || all.sorted[k - 1].ball < all.sorted[k].ball);
        ++found[all.sorted[k].ball];
      }
    }
    EXPECT_EQ(std::count(found.begin(), found.end(), 1), 1000);
  }
}

TEST(BlockSort, GivesOneOrderForAnyNumberOfWorkers) {
  Sorting one(0, 1);
  one.run(0);
  for (const std::size_t workers : {2U, 7U, 16U, 40U}) {
    Sorting more(0, workers);
    more.run(0);
    for (std::size_t k = 0; k < one.sorted.size(); ++k) {
      ASSERT_EQ(more.sorted[k].ball, one.sorted[k].ball) << workers;
    }
  }
}

TEST(BlockSort, TakesBlocksThatHaveBeenSet) {
  Sorting all(0, 2);
  for (std::size_t k = 0; k < 1000; ++k) all.sort.set_block(k, k % 2 == 0 ? 5 : 3);
  all.sort.set_known(true);
  all.run(0);
  EXPECT_EQ(all.sort.starts()[3], 0U);
  EXPECT_EQ(all.sort.starts()[4], 500U);
  EXPECT_EQ(all.sorted[0].ball, 1U);
  all.sort.set_known(false);
  all.run(0);
  EXPECT_EQ(all.block(all.sorted[0], 0), 0U);
}

TEST(BlockSort, FindsTheBallsThatAreLarger) {
  Sorting all(0, 2);
  all.run(0);
  all.sort.find_large(all.motion, all.sorted, 0.3);
  EXPECT_TRUE(all.sort.large().empty());
  all.sort.find_large(all.motion, all.sorted, 0.1);
  ASSERT_EQ(all.sort.large().size(), 20U);
  for (const auto& ball : all.sort.large()) {
    EXPECT_EQ(all.sorted[ball.memory].ball % 50, 7U);
    EXPECT_EQ(all.block(all.sorted[ball.memory], 0), static_cast<Index>(ball.block));
  }
}

}  // namespace
}  // namespace carom::event::block_sort_test
