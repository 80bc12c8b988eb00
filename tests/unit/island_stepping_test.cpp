#include "solvers/event/islands/island_stepping.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
  balls.add(0, 0);
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

// 30 degrees from the top: along the slope it gets g h sin 30.
TEST(IslandStepping, ABallOnASlopeSlidesOn) {
  IslandBalls balls(island_rules(0.5, 0.5));
  balls.add(0.5, std::sqrt(0.75));
  balls.add_fixed(0, 0);
  const Stepped after = stepped(balls, 0);
  EXPECT_EQ(after.island.support[0], kStepped);
  const Vec<double>& v = after.island.bodies[0].velocity;
  const double speed = balls.motion.speed_of_step();
  EXPECT_NEAR(v.x, speed * 0.5 * std::sqrt(0.75), 1e-3 * speed);
  EXPECT_NEAR(v.y, -speed * 0.25, 1e-3 * speed);
  EXPECT_EQ(after.change.counts.resting_contacts, 0U);
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

}  // namespace
}  // namespace carom::event::island_stepping_test
