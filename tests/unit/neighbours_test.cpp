#include "solvers/event/neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "solvers/event/neighbours_body.hpp"
#include "solvers/event/physics.hpp"

namespace carom::event::neighbours_test {
namespace {

constexpr Index kBalls = 200;

/// Balls of two sizes that fly through a box which is periodic one way.
struct Flying {
  Motion<Ballistic> motion{rules()};
  HugeVector<Disk> disks;
  Neighbours<Ballistic> neighbours{motion};

  explicit Flying(unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(0.5, 29.5);
    std::normal_distribution<double> normal;
    for (Index i = 0; i < kBalls; ++i) {
      Disk disk;
      disk.x = place(random);
      disk.y = place(random);
      disk.vx = normal(random);
      disk.vy = normal(random);
      disk.species = i % 2;
      disks.push_back(disk);
    }
    neighbours.reset(disks, 0);
    for (Index i = 0; i < kBalls; ++i) disks[i].leaves = neighbours.leaving(disks[i], i, 0);
  }

  static Rules rules() {
    Box box;
    box.width = 30;
    box.height = 30;
    box.periodic = {true, false};
    Rules rules{{box, true}, FixedTimeClock(2)};
    rules.all_species = {{0.5, 1}, {0.25, 1}};
    return rules;
  }
  [[nodiscard]] std::set<Index> listed(Index i) const {
    std::set<Index> all;
    neighbours.lists().each(i, [&](Index j) { EXPECT_TRUE(all.insert(j).second) << j; });
    return all;
  }
  /// All pairs that meet from now on while neither has left its square, looked at one by one.
  void expect_those_that_meet(FixedTime now) const {
    for (Index i = 0; i < kBalls; ++i) {
      const std::set<Index> mine = listed(i);
      EXPECT_FALSE(mine.contains(i));
      for (Index j = 0; j < kBalls; ++j) {
        if (j == i) continue;
        EXPECT_EQ(mine.contains(j), listed(j).contains(i)) << i << ' ' << j;
        const FixedTime at = motion.pair_event(disks[i], disks[j]);
        if (at >= now && at < std::min(disks[i].leaves, disks[j].leaves)) {
          EXPECT_TRUE(mine.contains(j)) << i << ' ' << j;
        }
      }
    }
  }
};

TEST(Neighbours, AreAllThatABallMayMeetBeforeEitherLeavesItsSquare) {
  const Flying flying(1);
  flying.expect_those_that_meet(0);
  std::size_t listed = 0;
  for (Index i = 0; i < kBalls; ++i) listed += flying.listed(i).size();
  EXPECT_GT(listed, kBalls);               // there are some,
  EXPECT_LT(listed, kBalls * kBalls / 4);  // and not just all
}

// Balls that leave their squares one after the other, and what is new to them.
TEST(Neighbours, AreMadeAgainWhenABallLeavesItsSquare) {
  Flying flying(2);
  for (int round = 0; round < 300; ++round) {
    Index first = 0;
    for (Index i = 0; i < kBalls; ++i) {
      if (flying.disks[i].leaves < flying.disks[first].leaves) first = i;
    }
    const FixedTime now = flying.disks[first].leaves;
    const Vec<double> here = flying.motion.place(flying.disks[first], now);
    if (here.y < 0.5 || here.y > 29.5) {  // it turns round at a wall
      flying.motion.carry(flying.disks[first], now);
      flying.disks[first].vy = -flying.disks[first].vy;
    }
    const std::set<Index> before = flying.listed(first);
    const auto span = flying.neighbours.renew(flying.disks, first, now);
    const std::set<Index> fresh(span.begin(), span.end());
    flying.disks[first].leaves = flying.neighbours.leaving(flying.disks[first], first, now);
    ASSERT_GT(flying.disks[first].leaves, now);
    for (const Index j : flying.listed(first))
      EXPECT_NE(before.contains(j), fresh.contains(j)) << j;
    if (round % 50 == 49) flying.expect_those_that_meet(now);
  }
}

TEST(Neighbours, AroundAPlaceAreAllThatAreNear) {
  Flying flying(3);
  for (double x = 0.25; x < 30; x += 1.7) {
    for (double y = 0.25; y < 30; y += 1.7) {
      const auto span = flying.neighbours.around(x, y);
      const std::set<Index> found(span.begin(), span.end());
      for (Index i = 0; i < kBalls; ++i) {
        const Vec<double> r = flying.motion.way({x, y}, {flying.disks[i].x, flying.disks[i].y});
        if (std::hypot(r.x, r.y) >= 1) continue;
        EXPECT_TRUE(found.contains(i)) << x << ' ' << y << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace carom::event::neighbours_test
