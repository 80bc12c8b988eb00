#include "solvers/event/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solvers/event/physics.hpp"
#include "support/flight_at.hpp"
#include "support/island_balls.hpp"

namespace carom::event::motion_test {
namespace {

/// A box of 10 by 10 around the origin; balls of radius 1/2 and mass 1, 2, and fixed ones.
Rules rules() {
  Box box;
  box.width = 10;
  box.height = 10;
  box.origin = Box::Origin::center;
  Rules rules{{box, true}, FixedTimeClock(0.5)};
  rules.all_species = {{0.5, 1}, {0.5, 0.5}, {0.5, 0}};
  return rules;
}

TEST(Motion, OfAFallIsAParabola) {
  Rules falling = rules();
  falling.gravity = {0, -2};
  const Motion<Ballistic> motion(falling);
  Disk thrown = flight_at(-1, 0, 1, 3);
  thrown.start = falling.scale.ticks(1);
  const FixedTime now = falling.scale.ticks(3);
  EXPECT_DOUBLE_EQ(motion.place(thrown, now).x, 1);
  EXPECT_DOUBLE_EQ(motion.place(thrown, now).y, 2);  // 3 * 2 - 2^2
  EXPECT_DOUBLE_EQ(motion.velocity(thrown, now).y, -1);
  EXPECT_DOUBLE_EQ(motion.place(flight_at(1, 1, 0, 0, 2), now).y, 1);  // a fixed one does not fall
}

// Dropped from h = 4.5 above where it touches the floor: after sqrt(2h / g), at sqrt(2gh), of which
// half is left.
TEST(Motion, ABallMeetsTheFloorAndBounces) {
  for (const double pull : {0.3, 1.1, 2.9, 3.7, 9.81}) {
    Rules falling = rules();
    falling.gravity = {0, -pull};
    falling.wall_restitution = 0.5;
    const Motion<Ballistic> motion(falling);
    Disk ball = flight_at(0, 0, 0, 0);
    const Meeting<Ballistic> floor = motion.alone(ball);
    EXPECT_EQ(floor.partner, kWalls + 2);
    EXPECT_NEAR(falling.scale.seconds(floor.time), std::sqrt(9 / pull), 1e-14);
    const double lost = motion.bounce(ball, nullptr, floor.partner, floor.time);
    EXPECT_EQ(ball.y, -4.5);
    EXPECT_NEAR(ball.vy, std::sqrt(9 * pull) / 2, 1e-14);
    EXPECT_NEAR(lost, 4.5 * pull * 3 / 4, 1e-13);
    EXPECT_EQ(ball.start, floor.time);
  }
}

TEST(Motion, TwoMeetWhenTheirDistanceIsThatOfTheirRadii) {
  const Motion<Ballistic> motion(rules());
  const Disk left = flight_at(-2, 0, 3, 0);
  const Disk right = flight_at(2, 0, -1, 0);
  const FixedTime at = motion.pair_event(left, right);
  EXPECT_NEAR(motion.rules().scale.seconds(at), 3.0 / 4, 1e-14);
  EXPECT_EQ(motion.pair_event(right, left), at);
  EXPECT_EQ(motion.pair_event(left, flight_at(2, 0, 4, 0)), kNever);
  EXPECT_EQ(motion.pair_event(left, flight_at(2, 1.5, -1, 0)), kNever);  // it passes by
  // The same pair, one of which started its flight later.
  Disk later = flight_at(1.5, 0, -1, 0);
  later.start = motion.rules().scale.ticks(0.5);
  EXPECT_NEAR(static_cast<double>(motion.pair_event(left, later) - at), 0, 4);
}

// Masses 1 and 2 at 3 and 0 with e = 1/2: the centre of mass goes at 1, the two apart at 3/2.
TEST(Motion, AStrikeKeepsMomentumAndTakesWhatRestitutionSays) {
  Rules lossy = rules();
  lossy.restitution = 0.5;
  const Motion<Ballistic> motion(lossy);
  Disk a = flight_at(0, 0, 3, 1);
  Disk b = flight_at(1, 0, 0, 1, 1);
  const auto strike = motion.strike(a, nullptr, b, nullptr, 0);
  EXPECT_NEAR(a.vx, 0, 1e-15);
  EXPECT_NEAR(b.vx, 1.5, 1e-15);
  EXPECT_EQ(a.vy, 1);
  EXPECT_EQ(b.vy, 1);
  EXPECT_NEAR(strike.lost, 4.5 - 2.25, 1e-15);
  EXPECT_EQ(strike.overlap, 0);
}

TEST(Motion, AFixedBallStaysWhereItIsStruck) {
  const Motion<Ballistic> motion(rules());
  Disk a = flight_at(0, 0, 3, 1);
  Disk peg = flight_at(1, 0, 0, 0, 2);
  EXPECT_TRUE(motion.fixed(peg));
  (void)motion.strike(a, nullptr, peg, nullptr, 0);
  EXPECT_EQ(a.vx, -3);
  EXPECT_EQ(a.vy, 1);
  EXPECT_EQ(peg.vx, 0);
}

// It fills the width, and friction at the floor presses it to one of the sides, where it has
// friction, too: N_x = mu N_y + g_x and N_y = 4 - mu N_x to the right, with mu = 1/2 N_x = 2.4 and
// N_y = 2.8; to the left N_x = 0.8 and N_y = 3.6.  It turns slower by 2 mu (N_x + N_y) / r.
TEST(Motion, WhatTurnsInATubeOfItsWidthIsPressedToEitherSide) {
  Box box;
  box.width = 1;
  box.height = 10;
  Rules tube{{box, true}, FixedTimeClock(0.5)};
  tube.gravity = {1, -4};
  tube.wall_friction = 0.5;
  tube.falls = tube.spins = tube.rests = true;
  tube.all_species = {{0.5, 1}};
  const Motion<Ballistic> motion(tube);
  for (const double spin : {-1.0, 1.0}) {
    Disk ball = flight_at(0.5, 0.5);
    double turning = spin;
    EXPECT_EQ(motion.support_on_walls(ball, &turning), 0);
    EXPECT_EQ(motion.support(ball), kSpins) << spin;
    const double slower = spin < 0 ? 2 * (2.4 + 2.8) : 2 * (0.8 + 3.6);
    EXPECT_NEAR(motion.spin_at(ball, turning, tube.scale.ticks(0.05)), spin * (1 - slower * 0.05),
                1e-12);
  }
}

// What a hit between steps leaves closing may be slow enough for a contact that lasts, and still
// close its gap before the next step: they meet then.  What fits into the gap is left to the step.
TEST(Motion, OfAnElasticIslandPairsMeetThatCloseTheirGapBeforeTheNextStep) {
  for (const double part : {0.9, 1.1}) {
    for (const unsigned support : {kStepped, 0U}) {
      IslandBalls balls(island_rules(1, 1));
      const double step = balls.motion.seconds_of_step();
      const double gap = balls.motion.speed_of_step() * step;
      balls.add(0, 0, part * balls.motion.speed_of_step(), 0, support);
      balls.add(1 + gap, 0, 0, 0, support);
      const FixedTime at = balls.motion.pair_event(balls.disks[0], balls.disks[1]);
      if (support == kStepped && part < 1) {
        EXPECT_EQ(at, kNever);
      } else {
        EXPECT_NEAR(balls.motion.rules().scale.seconds(at), step / part, 1e-9 * step);
      }
    }
  }
}

// It has flown for half of a step when it is hit: half of the gap is as much as it closes.
TEST(Motion, OfAnElasticIslandWhatIsHitBetweenStepsHasTheRestOfOne) {
  for (const double part : {0.9, 1.1}) {
    IslandBalls balls(island_rules(1, 1));
    const double step = balls.motion.seconds_of_step();
    balls.add(0, 0, balls.motion.speed_of_step(), 0, kStepped);
    balls.add(1 + balls.motion.speed_of_step() * step / 2 / part, 0, 0, 0, kStepped);
    for (Disk& disk : balls.disks) disk.start = balls.motion.rules().scale.ticks(step / 2);
    const FixedTime at = balls.motion.pair_event(balls.disks[0], balls.disks[1]);
    EXPECT_EQ(at == kNever, part < 1) << part;
  }
}

}  // namespace
}  // namespace carom::event::motion_test
