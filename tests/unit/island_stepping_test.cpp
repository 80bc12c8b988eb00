#include "solvers/event/islands/island_stepping.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/rest_rules.hpp"
#include "solvers/event/islands/island_stepping_body.hpp"
#include "support/island_balls.hpp"

namespace carom::event::island_stepping_test {
namespace {

using Island = FoundIsland<double>;

struct Stepped {
  Island island;
  IslandChange change;
};

/// The island of a ball after a step.
Stepped stepped(IslandBalls& balls, Index ball) {
  const IslandStepping<Ballistic> stepping(balls.motion, balls.disks, balls.impulses);
  Stepped result{balls.around(ball), {}};
  result.change = stepping.step(result.island);
  EXPECT_EQ(result.change.counts.steps, 1U);
  return result;
}

/// The ball, which stands, was of an island in the step before, too: that has given it half of what
/// gravity made in it.
void make_older(IslandBalls& balls, Index ball) {
  balls.disks[ball].start = -FixedTimeClock::span(1, balls.motion.step_shift());
}

TEST(IslandStepping, WhatNothingCarriesLeavesAsItWas) {
  IslandBalls balls(island_rules(0.5, 0.5));
  balls.add(0, 0, 3, -2);
  const Stepped after = stepped(balls, 0);
  EXPECT_EQ(after.island.support[0], 0U);
  EXPECT_EQ(after.island.bodies[0].velocity, (Vec<double>{3, -2}));
  EXPECT_EQ(after.change.carried.lost, 0);
}

// Two fixed balls at 60 degrees to either side carry 1 / (2 cos 60) = 1 of what gravity makes.
TEST(IslandStepping, ABallInAGrooveComesToRest) {
  IslandBalls balls(island_rules(0.5, 0.5));
  const double x = std::sqrt(0.75);
  make_older(balls, balls.add(0, 0));
  balls.add_fixed(x, -0.5);
  balls.add_fixed(-x, -0.5);
  const Stepped after = stepped(balls, 0);
  EXPECT_EQ(after.island.support[0], kResting);
  EXPECT_EQ(after.island.bodies[0].velocity, (Vec<double>{0, 0}));
  EXPECT_EQ(after.change.counts.resting_contacts, 2U);
  for (const double load : after.change.carried.impulses) {
    EXPECT_NEAR(load, balls.motion.speed_of_step(), 1e-3 * balls.motion.speed_of_step());
  }
}

// 30 degrees from the top: along the slope it gets g h sin 30, and half of that when it joins.
TEST(IslandStepping, ABallOnASlopeSlidesOn) {
  for (const bool joins : {true, false}) {
    IslandBalls balls(island_rules(0.5, 0.5));
    balls.add(0.5, std::sqrt(0.75));
    if (!joins) make_older(balls, 0);
    balls.add_fixed(0, 0);
    const Stepped after = stepped(balls, 0);
    EXPECT_EQ(after.island.support[0], kStepped);
    const Vec<double>& v = after.island.bodies[0].velocity;
    const double speed = (joins ? 0.5 : 1) * balls.motion.speed_of_step();
    EXPECT_NEAR(v.x, speed * 0.5 * std::sqrt(0.75), 1e-3 * speed);
    EXPECT_NEAR(v.y, -speed * 0.25, 1e-3 * speed);
    EXPECT_EQ(after.change.counts.resting_contacts, 0U);
  }
}

// The same where nothing takes energy: it begins no faster than gravity makes it.
TEST(IslandStepping, AnElasticBallOnASlopeBeginsAsSlowly) {
  IslandBalls balls(island_rules(1, 1));
  balls.add(0.5, std::sqrt(0.75));
  balls.left_out = {0};
  balls.add_fixed(0, 0);
  const Stepped after = stepped(balls, 0);
  const Vec<double>& v = after.island.bodies[0].velocity;
  const double speed = 0.5 * balls.motion.speed_of_step();
  EXPECT_NEAR(v.x, speed * 0.5 * std::sqrt(0.75), 1e-3 * speed);
  EXPECT_NEAR(v.y, -speed * 0.25, 1e-3 * speed);
  EXPECT_NEAR(after.change.carried.lost, 0, 1e-16);
  EXPECT_NEAR(after.island.left_out[0], speed * speed * 0.25 / 2, 1e-3 * speed * speed);
}

// What was given half of what gravity makes in its flight gets the other half, with the speed that
// a ball has that was free all the time; then gravity has given nothing ahead.
TEST(IslandStepping, WhatNothingCarriesAnyMoreLeavesWithAllThatGravityMade) {
  IslandBalls balls(island_rules(0.5, 0.5));
  balls.add(0, 0, 3, -2);
  make_older(balls, 0);
  const double h = balls.motion.seconds_of_step();
  const Stepped after = stepped(balls, 0);
  EXPECT_EQ(after.island.support[0], 0U);
  EXPECT_EQ(after.island.bodies[0].velocity, (Vec<double>{3, -2 - h / 2}));
  // It is counted with the energy of its middle, and of the place where it was then:
  // (2 + h / 2)^2 / 2 = 2^2 / 2 + 2 h / 2 + (h / 2)^2 / 2.
  EXPECT_NEAR(after.change.carried.lost, -h * h / 8, 1e-15);
}

TEST(IslandStepping, ABallThatOnlyAWallCarriesSlidesAlongItOnItsOwn) {
  IslandBalls balls(island_rules(0.5, 0.5));
  balls.add(0, -9.5, 2, 0);
  const Stepped after = stepped(balls, 0);
  EXPECT_EQ(after.island.support[0], 0U);
  EXPECT_EQ(after.island.bodies[0].velocity, (Vec<double>{2, 0}));
}

// A ball on another that lies on the floor, straight above it, and one on its side: what is pulled
// moves on, and wakes what it touches.
TEST(IslandStepping, AColumnRestsUnlessABallSlidesOffIt) {
  for (const bool leans : {false, true}) {
    IslandBalls balls(island_rules(0.5, 0.5));
    balls.add(0, -9.5);
    balls.add(leans ? 0.6 : 0, leans ? -8.7 : -8.5);
    const Stepped after = stepped(balls, 0);
    for (const unsigned support : after.island.support) {
      EXPECT_EQ(support, leans ? kStepped : kResting);
    }
    EXPECT_EQ(after.change.counts.resting_contacts, leans ? 0U : 2U);
  }
}

// What rests already is not counted again.
TEST(IslandStepping, ContactsAreCountedWhenTheyComeToRest) {
  IslandBalls balls(island_rules(0.5, 0.5));
  balls.add(0, -9.5, 0, 0, kResting);
  balls.add(0, -8.5, 0, 0, kResting);
  const Stepped after = stepped(balls, 0);
  EXPECT_EQ(after.island.support[1], kResting);
  EXPECT_EQ(after.change.counts.resting_contacts, 0U);
}

// Six rows of balls from wall to wall, on a floor, and one more that glides along their top.  What
// stands far from it is asked whether it does only where all are: then a column that nothing holds
// up falls.
struct Heap {
  static constexpr int kColumns = 20;
  static constexpr int kRows = 6;
  static constexpr int kHole = 2;  ///< the column whose lowest ball is missing
  IslandBalls balls{island_rules(0.5, 0.5)};

  explicit Heap(bool hole = true) {
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kColumns; ++column) {
        if (hole && row == 0 && column == kHole) continue;
        balls.add(column - 9.5, row - 9.5, 0, 0, kResting);
      }
    }
    balls.add(5.5, kRows - 9.5, 0.25, 0);
  }
  [[nodiscard]] Index glides() const { return static_cast<Index>(balls.disks.size() - 1); }
  Island step(bool whole) {
    const IslandStepping<Ballistic> stepping(balls.motion, balls.disks, balls.impulses);
    Island island = balls.around(glides());
    stepping.step(island, whole);
    for (std::size_t m = 0; m < island.members.size(); ++m) {
      Disk& disk = balls.disks[island.members[m]];
      disk.vx = island.bodies[m].velocity.x;
      disk.vy = island.bodies[m].velocity.y;
      balls.motion.set_support(disk, island.support[m]);
    }
    return island;
  }
  [[nodiscard]] bool falls() const { return balls.disks[kColumns + 1].vy < 0; }
};

TEST(IslandStepping, WhatStandsFarFromWhatMovesIsAskedAgainWithAll) {
  Heap heap;
  for (Disk& disk : heap.balls.disks) {
    const bool near = disk.x > 2 && disk.y > -7;
    if (near) heap.balls.motion.set_support(disk, kStepped);
  }
  const Island part = heap.step(false);
  ASSERT_TRUE(is_large(part));
  EXPECT_FALSE(heap.falls());
  EXPECT_EQ(heap.balls.disks[heap.glides()].vx, 0.25);
  EXPECT_NEAR(heap.balls.disks[heap.glides()].vy, 0, 1e-3 * heap.balls.motion.speed_of_step());
  heap.step(true);
  EXPECT_TRUE(heap.falls());
}

TEST(IslandStepping, OnlyWhatIsNearToWhatMovesGoesOnMoving) {
  Heap heap(false);
  for (Disk& disk : heap.balls.disks) heap.balls.motion.set_support(disk, kStepped);
  const Island island = heap.step(true);
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    const Vec<double>& at = island.places[m];
    const double far = std::abs(at.x - 5.5) + (Heap::kRows - 9.5 - at.y);
    if (far > kMovesAlong + 0.5) {
      EXPECT_EQ(island.support[m], kResting) << at.x << ' ' << at.y;
    } else if (far < kMovesAlong + 0.5) {
      EXPECT_GE(island.support[m], kStepped) << at.x << ' ' << at.y;
    }
  }
}

// Though none of what stands has been told, it feels what comes beside it.
TEST(IslandStepping, WhatMovesBesideWhatStandsWakesIt) {
  Heap heap;
  heap.step(false);
  EXPECT_TRUE(heap.falls());
}

}  // namespace
}  // namespace carom::event::island_stepping_test
