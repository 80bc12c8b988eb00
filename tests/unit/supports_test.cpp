#include "solvers/event/supports.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/island_balls.hpp"

namespace carom::event::supports_test {
namespace {

struct Carried : IslandBalls {
  std::vector<Index> left = std::vector<Index>(10, kUnknown);
  Counts counts;
  EnergyBook book;
  std::vector<double> left_out;
  Supports<Ballistic> supports{motion, {disks, spins, left, left_out}, neighbours, counts, book};

  Carried() : IslandBalls(island_rules(0.5, 0.5)) {}
  [[nodiscard]] unsigned support(Index i) const { return motion.support(disks[i]); }
};

// So slow a bounce is over before the clock moves: the ball lies on the floor, and its energy is
// lost.
TEST(Supports, AFloorCarriesWhatLeavesItNoMore) {
  Carried balls;
  const double slow = 0x1p-60;
  balls.add(0, -9.5, 3, slow, 0, 2);
  balls.add(4, -9.5, 0, 1, 0);
  balls.add(-4, -9, 0, 0, 0);
  for (Index i = 0; i < 3; ++i) balls.supports.update(i);
  EXPECT_EQ(balls.support(0), 2U);
  EXPECT_EQ(balls.disks[0].vy, 0);
  EXPECT_EQ(balls.book.keep(), slow * slow);  // of a mass of 2
  EXPECT_EQ(balls.support(1), 0U);
  EXPECT_EQ(balls.support(2), 0U);
  EXPECT_EQ(balls.counts.resting_contacts, 1U);
  balls.supports.update(0);
  EXPECT_EQ(balls.counts.resting_contacts, 1U);
  balls.disks[0].vy = 1;  // it is hit
  balls.supports.update(0);
  EXPECT_EQ(balls.support(0), 0U);
}

TEST(Supports, AFixedBallCarriesWhatStandsOnItsTop) {
  Carried balls;
  balls.add_fixed(0, 0);
  balls.add(0, 1, 0, 0, 0);
  balls.supports.update(1);
  EXPECT_EQ(balls.support(1), 0U);  // its flight did not begin there
  balls.left[1] = 0;
  balls.supports.update(1);
  EXPECT_EQ(balls.support(1), kLying);
  EXPECT_EQ(balls.counts.resting_contacts, 1U);
  balls.disks[1].x = 0x1p-20;
  balls.supports.update(1);
  EXPECT_EQ(balls.support(1), 0U);
}

TEST(Supports, AtTheStartOnlyWhatBeginsNowIsPutOnWalls) {
  Carried balls;
  balls.add(0, -9.5, 0, 0, 0);
  balls.add(4, -9.5, 0, 0, 0);
  balls.disks[1].start = -1;
  balls.add(8, -9.5, 0, 0, kResting);
  balls.supports.begin(0);
  EXPECT_EQ(balls.support(0), 2U);
  EXPECT_EQ(balls.support(1), 0U);
  EXPECT_EQ(balls.support(2), kResting);
  EXPECT_FALSE(balls.supports.any_stepped());
  balls.add(0, 0, 0, 0, kJoins);
  EXPECT_TRUE(balls.supports.any_stepped());
}

TEST(Supports, WhatRestsAroundABallIsWoken) {
  Carried balls;
  balls.add(0, 0, 0, 0, kResting);
  balls.add(1, 0, 0, 0, kResting);
  balls.add(0, 1, 0, 0, kLying);
  balls.add(-1, 0, 0, 0, 0);
  balls.add(0, -1, 0, 0, kStepped);
  balls.add(0.6 * (1 + 2 * kNear), -0.8 * (1 + 2 * kNear), 0, 0, kResting);  // it is not near
  balls.begin();
  balls.supports.wake_around(0, 0);
  EXPECT_EQ(balls.support(1), kJoins);
  EXPECT_EQ(balls.support(2), kJoins);
  EXPECT_EQ(balls.support(3), 0U);
  EXPECT_EQ(balls.support(4), kStepped);
  EXPECT_EQ(balls.support(5), kResting);
}

// Gravity 1 has given a mass of 2 that falls at 3 what it gets in 1/8 s, half of its flight: 2 * 3
// / 8; at its end it is owed as much.
TEST(Supports, IslandsAreGivenWhatTheyWillHaveFallen) {
  Carried balls;
  balls.add(0, 0, 7, -3, kStepped, 2);
  balls.add(4, 0, 0, -5, kResting);
  balls.add(8, 0, 0, -5, 0);
  balls.add_fixed(0, 8);
  const FixedTime next = balls.motion.rules().scale.ticks(0.25);
  EXPECT_NEAR(balls.supports.given_ahead(0, next), 0.75, 1e-12);
  EXPECT_EQ(balls.supports.given_ahead(next / 2, next), 0);
  EXPECT_NEAR(balls.supports.given_ahead(next, next), -0.75, 1e-12);
}

}  // namespace
}  // namespace carom::event::supports_test
