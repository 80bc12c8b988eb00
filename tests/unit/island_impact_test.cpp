#include "solvers/event/islands/island_impact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "solvers/event/islands/island_impact_body.hpp"
#include "support/island_balls.hpp"

namespace carom::event::island_impact_test {
namespace {

using Island = FoundIsland<double>;

struct Hit {
  Island island;
  IslandChange change;

  /// What has become of a ball.
  [[nodiscard]] Vec<double> velocity(Index ball) const { return island.bodies[at(ball)].velocity; }
  [[nodiscard]] unsigned support(Index ball) const { return island.support[at(ball)]; }

 private:
  [[nodiscard]] std::size_t at(Index ball) const {
    for (std::size_t m = 0; m < island.members.size(); ++m) {
      if (island.members[m] == ball) return m;
    }
    throw std::logic_error("no member");
  }
};

/// Nothing has hit the balls of late: they are where they were said to be, and as fast, at the
/// start, from flights that began before.
void make_older(IslandBalls& balls) {
  const FixedTime age = balls.motion.rules().scale.ticks(0.25);
  for (Disk& disk : balls.disks) {
    if (balls.motion.fixed(disk)) continue;
    // Flights of what is stepped began with the step, where there are steps.
    if (balls.next_step != kNever && balls.motion.support(disk) == kStepped) continue;
    const Vec<double> pull = balls.motion.law_of(disk).pull();
    disk.x += 0.25 * (0.125 * pull.x - disk.vx);
    disk.y += 0.25 * (0.125 * pull.y - disk.vy);
    disk.vx -= 0.25 * pull.x;
    disk.vy -= 0.25 * pull.y;
    disk.start = -age;
  }
}

/// Of the balls together; where `seconds` is 0 no step follows.
Hit hit(IslandBalls& balls, const std::vector<Index>& which, double seconds = 0) {
  const IslandImpact<Ballistic> impact(balls.motion, balls.disks, balls.impulses);
  make_older(balls);
  balls.begin();
  Hit result{balls.search.of_hits({which}, 0).front(), {}};
  result.change = impact.resolve(result.island, {seconds}, 0);
  return result;
}

// A mass of 2 that comes at 3 to a wall of restitution 1/4 loses 2 (9 - 9/16) / 2.
TEST(IslandImpact, ABallOfAnIslandLeavesAWallByItsRestitution) {
  IslandBalls balls(island_rules(0.5, 0.25));
  balls.add(0, -9.5, 1, -3, kStepped, 2);
  const Hit after = hit(balls, {0});
  EXPECT_NEAR(after.velocity(0).x, 1, 1e-12);
  EXPECT_NEAR(after.velocity(0).y, 0.75, 1e-3);  // as exactly as a hit is solved
  EXPECT_NEAR(after.change.carried.lost, 9 - 9.0 / 16, 0.01);
  EXPECT_EQ(after.change.counts.ball_wall, 1U);
  EXPECT_EQ(after.change.counts.joint_impacts, 0U);
  EXPECT_EQ(after.island.contacts[0].parting, 0);
}

// Equal masses at 1 and 0 leave at (1 - e) / 2 and (1 + e) / 2; a push across does nothing.
TEST(IslandImpact, TwoPartByTheirRestitution) {
  IslandBalls balls(island_rules(0.5, 0.5));
  balls.add(0, 0, 1, 0.25);
  balls.add(1, 0);
  const Hit after = hit(balls, {0, 1});
  EXPECT_NEAR(after.velocity(0).x, 0.25, 1e-3);
  EXPECT_NEAR(after.velocity(1).x, 0.75, 1e-3);
  EXPECT_NEAR(after.velocity(0).y, 0.25, 1e-12);
  EXPECT_NEAR(after.change.carried.impulses[0], 0.75, 1e-3);
  EXPECT_NEAR(after.change.carried.lost, (1 - 0.625) / 2, 1e-3);
  EXPECT_EQ(after.change.counts.ball_ball, 1U);
}

// A row of elastic balls passes on what comes in.
TEST(IslandImpact, AnElasticRowIsACradle) {
  IslandBalls balls(island_rules(1, 1));
  for (int k = 0; k < 4; ++k) balls.add(k, 0, k == 0 ? 2 : 0, 0);
  const Hit after = hit(balls, {0, 1});
  for (Index k = 0; k < 4; ++k) EXPECT_NEAR(after.velocity(k).x, k == 3 ? 2 : 0, 1e-12) << k;
  EXPECT_NEAR(after.change.carried.lost, 0, 1e-12);
}

TEST(IslandImpact, WhatRestedIsWokenAndWhatBouncesOffLeaves) {
  IslandBalls balls(island_rules(0.5, 0.5));
  balls.add(0, 0, 0, 0, kResting);
  balls.add(1, 0, 0, 0, kResting);
  balls.add(-1, 0, 3, 0, 0);
  const Hit after = hit(balls, {2, 0});
  EXPECT_EQ(after.change.woken, (std::vector<Index>{0, 1}));
  EXPECT_EQ(after.change.counts.wakes, 1U);
  EXPECT_EQ(after.support(0), kStepped);
  EXPECT_EQ(after.support(1), kStepped);
  EXPECT_EQ(after.support(2), 0U);
}

// What would be back within a step is of the island.
TEST(IslandImpact, WhatComesSlowlyIsOfTheIslandFromThenOn) {
  for (const double part : {0.5, 2.0}) {
    IslandBalls balls(island_rules(0.5, 0.5));
    const double speed = part * balls.motion.speed_of_step();
    balls.add(0, 0);
    balls.add(0, 1, 0.125, -speed, 0);
    const Hit after = hit(balls, {0, 1});
    EXPECT_EQ(after.support(1), part < 1 ? kStepped : 0U) << part;
  }
}

// Ball 0 lies on the side of a fixed one and slides, by gravity, into ball 1, which flies and parts
// from it at p.  By N and J of the contacts 0 has u along the slope, and 1 as much to its side:
//   u = 0.6 g h / 2 - 0.8 J,  p + J = 0.8 u.
// At p above 0.48 g h / 2 it is gone before 0 comes.
TEST(IslandImpact, WhatLeavesMoreSlowlyThanGravityBringsAnElasticBallAfterItStays) {
  constexpr double kHalf = 0x1p-9;
  for (const double p : {0x1p-20, 0x1p-9}) {
    IslandBalls balls(island_rules(1, 1));
    balls.add(0, 0, 0, 0, 0);
    balls.add(-1, 0, -p, 0, 0);
    balls.add_fixed(0.6, -0.8);
    balls.left_out.assign(3, 0.0);
    const Hit after = hit(balls, {0, 1}, 2 * kHalf);
    EXPECT_EQ(after.support(0), kStepped);
    if (p > 0.48 * kHalf) {
      EXPECT_EQ(after.support(1), 0U);
      EXPECT_NEAR(after.velocity(1).x, -p, 1e-6 * p);
      continue;
    }
    EXPECT_EQ(after.support(1), kStepped);
    const double u = (0.6 * kHalf + 0.8 * p) / 1.64;
    EXPECT_NEAR(after.velocity(0).x, -0.8 * u, 1e-3 * u);
    EXPECT_NEAR(after.velocity(1).x, -0.8 * u, 1e-3 * u);
    EXPECT_NEAR(after.velocity(1).y, -kHalf, 1e-3 * kHalf);
  }
}

// It comes down so slowly that it closes its gap just until the step: the floor's impulse has taken
// what gravity has made ahead.  A ball of the same mass that hits it then leaves as fast as it was.
TEST(IslandImpact, WhatIsHeldAboveAFloorUntilTheStepHasNoGravityToGiveBack) {
  constexpr double kStep = 0x1p-6;
  constexpr double kGap = 0x1p-20;
  IslandBalls balls(island_rules(1, 1));
  balls.add(0, 0, 0, -kGap / kStep);
  balls.add(0, 1, 0, -1, 0);
  balls.add_fixed(0, -1 - kGap);
  balls.left_out.assign(3, 0.0);
  balls.next_step = balls.motion.rules().scale.ticks(kStep);
  const Hit after = hit(balls, {0, 1}, kStep);
  EXPECT_NEAR(after.velocity(1).y, -kGap / kStep, kStep / 32) << "g h / 2 is 16 times that";
}

// It was a little above the floor.
TEST(IslandImpact, WhatIsAtAWallIsExactlyThereAndDoesNotGoIntoIt) {
  IslandBalls balls(island_rules(0.5, 0));
  balls.add(0, -9.5 + kTouching / 4, 1, -2);
  const Hit after = hit(balls, {0}, 0x1p-8);
  EXPECT_EQ(after.island.places[0].y, -9.5);
  EXPECT_EQ(after.velocity(0).y, 0);
  EXPECT_LT(after.island.lifted, 0);
}

/// A square lattice of 12 by 12 balls that touch, and ball 144, which comes to ball 137 from 1/32
/// above it, at 1.
IslandBalls& add_heap(IslandBalls& balls) {
  for (int k = 0; k < 144; ++k) {
    const int row = k / 12;
    balls.add(k % 12 - 5, row - 5);
  }
  balls.add(0, 7 + 0x1p-5, 0, -1, 0);
  balls.next_step = balls.motion.rules().scale.ticks(0x1p-4);
  return balls;
}

// It will come at v, v^2 = 1 + 2 / 32, leave at e v, and be slower, u^2 = e^2 v^2 - 2 / 32, when it
// is where it is now: as fast as that it leaves at once, less what gravity makes in half of the
// time till the step.
TEST(IslandImpact, WhatComesToManyIsTurnedRoundAsFastAsItWillBeOnItsWayBack) {
  IslandBalls balls(island_rules(0.5, 0.25));
  const Hit after = hit(add_heap(balls), {0}, 0x1p-4);
  EXPECT_EQ(after.change.counts.ball_ball, 1U);
  EXPECT_EQ(after.support(144), kStepped);
  const double back = std::sqrt(0.25 * (1 + 0x1p-4) - 0x1p-4) - 0x1p-5;
  EXPECT_NEAR(after.velocity(144).y - after.velocity(137).y, back, 1e-3);
  EXPECT_GT(after.change.carried.lost, 0);
}

// All fall by half of a step as well, as they join now, and the impact passes on what the ball
// brings.
TEST(IslandImpact, AStepAtTheSameTimeGivesGravityToAll) {
  IslandBalls balls(island_rules(0.5, 0.5));
  add_heap(balls);
  balls.begin();
  const IslandImpact<Ballistic> impact(balls.motion, balls.disks, balls.impulses);
  Island island = balls.search.of_step({0}, 0, balls.next_step).front();
  const IslandChange change = impact.resolve(island, {0x1p-4}, 0, true);
  EXPECT_EQ(change.counts.steps, 1U);
  EXPECT_EQ(change.counts.ball_ball, 1U);
  double momentum = 0;
  for (const ConeBody& body : island.bodies) momentum += body.velocity.y;
  EXPECT_NEAR(momentum, -1 - 145 * 0x1p-5, 1e-9);
  EXPECT_EQ(std::count(island.support.begin(), island.support.end(), kStepped), 145);
}

}  // namespace
}  // namespace carom::event::island_impact_test
