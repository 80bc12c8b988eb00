// What contact islands do from step to step, against what theory says of it.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/event_contact.hpp"

namespace carom::event_stepping_test {
namespace {

// g_x t^2 / 2, though what slides is stepped; and where it is at each step, not at the end alone.
// Seen to fail where a ball that joins an island gets all that gravity makes in the step: .2 %
// ahead after 4 s.
TEST(EventStepping, AStackSlidesOnTiltedIceByHalfOfGTSquared) {
  for (const double tilt : {1e-4, 1e-6, 0.25}) {
    for (const double drag : {0.0, 0.5}) {
      Scene scene = test::contact_box(100, 12, 0.5, {tilt * 9.81, -9.81});
      if (drag > 0) scene.effects.drag = Drag{drag};
      for (const double time : {0.5, 4.0}) {
        const auto end = test::run_contact(
            scene, {test::contact_ball(5, 0.5), test::contact_ball(5, 1.5)}, time);
        const double fades = drag * time;
        const double way =
            drag > 0 ? (fades + std::expm1(-fades)) / (drag * drag) : time * time / 2;
        for (const Ball& each : end.balls) {
          const double slid = tilt * 9.81 * way;
          // To second order in the rate of drag and the step of 1/128 s.
          const double most = drag > 0 ? 2e-5 * slid : 1e-9 * slid + 1e-12;
          EXPECT_NEAR(each.position.x() - 5, slid, most) << tilt << ' ' << drag << ' ' << time;
        }
        EXPECT_LT(end.measured.max_overlap, 1e-6);
      }
    }
  }
}

/// Two balls in a row that just fit between a fixed one and a wall, to which the second one comes:
/// it has no way but up.
std::vector<Ball> row() {
  std::vector<Ball> balls{test::fixed_ball(1, 1, 1), test::contact_ball(3, 1, 0, 0, 1),
                          test::contact_ball(5, 1, 1, 1, 1)};
  balls[1].mass = 5.110551826074183;
  balls[2].mass = 9.595602645681616;
  return balls;
}

// A ball that turns round is slow for a moment, but is pulled.
// Seen to fail where such a one was stopped, as it could not go as fast as its energy asks for.
TEST(EventStepping, WhatTurnsRoundInARowDoesNotComeToRest) {
  const Scene scene = test::contact_box(6, 4, 1, {3, -4});
  const double energy = test::run_contact(scene, row(), 0).energy_before;
  for (double time = 0.5; time <= 3; time += 0.5) {
    const auto end = test::run_contact(scene, row(), time);
    EXPECT_NEAR(end.energy, energy, 1e-11 * std::abs(energy)) << time;
    double speed = 0;
    for (const Ball& each : end.balls) speed += each.velocity.norm();
    EXPECT_GT(speed, 1e-3) << time;
    EXPECT_LT(end.measured.max_overlap, 1e-4) << time;
  }
}

// Of a motion with elastic impacts drag takes 2 k times its energy, which is initially 9.6 J and
// grows by what the balls fall, here nothing; they have most of it as height in between.
// Seen to fail where such a row lost .8 J in its first impact, and overlapped by 5e-3.
TEST(EventStepping, OnlyDragTakesEnergyWhereImpactsAreElastic) {
  const double rate = 1e-6;
  Scene scene = test::contact_box(6, 4, 1, {3, -4});
  scene.effects.drag = Drag{rate};
  const auto end = test::run_contact(scene, row(), 3);
  EXPECT_GT(end.dissipated, 0);
  EXPECT_LT(end.dissipated, 2 * rate * 3 * 9.6);
  EXPECT_LT(end.measured.max_overlap, 1e-4);
}

// Only walls lose energy: a ball that slides off another one, from rest in a corner, has what it
// falls, and no more: nothing is gained.
// Seen to fail where steps were short only if impacts of balls lose energy, too: 5e-5.
TEST(EventStepping, WhatSlidesOffAnElasticBallHasWhatItFalls) {
  Scene scene = test::contact_box(2, 5, 1, {0, -9.81});
  scene.effects.walls->restitution = 0.9;
  std::vector<Ball> balls{test::contact_ball(0.5, 0.5),
                          test::contact_ball(1, 0.5 + std::sqrt(0.75))};
  balls[0].mass = 10.9;
  balls[1].mass = 13.8;
  for (double time = 0.1; time <= 0.5; time += 0.1) {
    const auto end = test::run_contact(scene, balls, time);
    EXPECT_GT(end.dissipated, -1e-8 * end.energy_before) << time;
    EXPECT_LT(end.measured.max_overlap, 1e-6) << time;
  }
}

// What has no room to bounce does not, and drives nothing through anything.
// Seen to fail where impulses were looked for that part two as fast as they should, and nothing can
// be moved: overlaps of 5e-3.
TEST(EventStepping, WhatIsWedgedDoesNotOverlap) {
  for (const double restitution : {0.3, 0.5, 0.9}) {
    const Scene scene = test::contact_box(6, 4, restitution, {3, -4});
    for (double time = 0.25; time <= 1; time += 0.25) {
      const auto end = test::run_contact(scene, row(), time);
      EXPECT_LT(end.measured.max_overlap, 1e-5) << restitution << ' ' << time;
      EXPECT_NEAR(end.energy + end.dissipated, end.energy_before, 1e-11) << restitution;
    }
  }
}

}  // namespace
}  // namespace carom::event_stepping_test
