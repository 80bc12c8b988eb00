#include "solvers/event/islands/island_impulses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/island_balls.hpp"

namespace carom::event::island_impulses_test {
namespace {

using Island = FoundIsland<double>;

// Masses 2 and 1 at 3 and 0 go on at 2 together: the impulse is 2.
TEST(IslandImpulses, StopWhatApproaches) {
  IslandBalls balls(island_rules(0.5, 0.5));
  balls.add(0, 0, 3, 0, kStepped, 2);
  balls.add(1, 0);
  Island island = balls.around(0);
  std::vector<double> loads{1};
  balls.impulses.press(island, {}, 1e-12, loads);
  for (const ConeBody& body : island.bodies) EXPECT_NEAR(body.velocity.x, 2, 1e-12);
  EXPECT_NEAR(loads[0], 1 + 2, 1e-12);  // it is added to what there was
}

// A gap of 1/128 may close in a span of 1/64: half of the speed of 1 stays.
TEST(IslandImpulses, LetAGapCloseUntilTheNextStep) {
  IslandBalls balls(island_rules(0.5, 0.5));
  balls.add(0, 0, 1, 0);
  balls.add(1 + 0x1p-7, 0);
  Island island = balls.around(0);
  std::vector<double> loads{0};
  balls.impulses.press(island, {0x1p-6}, 1e-12, loads);
  EXPECT_NEAR(approach(island, 0), 0.5, 1e-9);
  EXPECT_NEAR(loads[0], 0.25, 1e-9);
}

// What nothing has stopped approaches no faster than 2 h (g + u^2 / s) in a step of h, at a slip u,
// of which no more counts than turns a contact by 2^-8.
TEST(IslandImpulses, LastOnlyWhereASlowApproachIsNoImpact) {
  for (const double slip : {0.0, 0.125, 2.0}) {
    for (const double part : {0.99, 1.01}) {
      for (const bool elastic : {true, false}) {
        IslandBalls balls(island_rules(elastic ? 1 : 0.5, elastic ? 1 : 0.5));
        const double step = balls.motion.seconds_of_step();
        const double turn = std::min(slip * step, 0x1p-8);
        const double most = 2 * (step + turn * turn / step);
        balls.add(0, 0, part * most, slip);
        balls.add(1, 0);
        EXPECT_EQ(balls.impulses.lasts(balls.around(0), 0), part < 1 || !elastic)
            << slip << ' ' << part << ' ' << elastic;
      }
    }
  }
}

// Elastic ones that leave the island meet at their own time.
TEST(IslandImpulses, HoldElasticOnesOnlyWhereBothStay) {
  for (const unsigned support : {kStepped, 0U}) {
    IslandBalls balls(island_rules(1, 1));
    balls.add(0, 0, balls.motion.speed_of_step(), 0);
    balls.add(1, 0);
    Island island = balls.around(0);
    island.support[1] = support;
    std::vector<double> loads{0};
    balls.impulses.press(island, {0x1p-6}, 1e-12, loads);
    EXPECT_EQ(loads[0] > 0, support == kStepped);
  }
}

// The others touch what they press: what is only near, and leaves, meets it at its own time.
TEST(IslandImpulses, HoldWhatIsNearOnlyWhereBothStay) {
  for (const unsigned support : {kStepped, 0U}) {
    IslandBalls balls(island_rules(0.5, 0.5));
    balls.add(0, 0, 1, 0);
    balls.add(1 + 0x1p-10, 0);
    Island island = balls.around(0);
    island.support[1] = support;
    std::vector<double> loads{0};
    balls.impulses.press(island, {0x1p-6}, 1e-12, loads);
    EXPECT_EQ(loads[0] > 0, support == kStepped);
  }
}

// Two go on together, so much faster that they keep the energy: at (1, -u) and (0, -u) they come to
// (1/2, -u) f, with f^2 = (1 + 2 u^2) / (1/2 + 2 u^2).
TEST(IslandImpulses, KeepTheEnergyWhereAGapIsKept) {
  for (const bool gives_up : {false, true}) {
    for (const double drag : {0.0, 1e-9}) {
      Rules rules = island_rules(1, 1);
      rules.drag_rate = drag;
      IslandBalls balls(rules);
      const double v = balls.motion.speed_of_step();
      balls.add(0, 0, v, -4 * v);
      balls.add(1, 0, 0, -4 * v);
      Island island = balls.around(0);
      for (int k = 0; k <= kMostDoublings && gives_up; ++k) balls.jam.widen();
      const double had = balls.impulses.energy().of(island, {}).all();
      const SteppedFlight next = balls.motion.whole_flight();
      // What gravity has given ahead is not theirs, and so is not kept; here it is little.
      std::vector<double> loads{0};
      balls.impulses.keep_gaps(island, had, next, 1e-12 * v, loads);
      // What gives up keeps it, too, where nothing takes any.
      const bool keeps = !gives_up || drag == 0;
      EXPECT_EQ(approach(island, 0) < 1e-9 * v, keeps);
      const SteppedEnergy::Parts kept = balls.impulses.energy().of(island, next);
      if (!keeps) continue;
      EXPECT_NEAR(kept.all(), had, 1e-9 * had);
    }
  }
}

}  // namespace
}  // namespace carom::event::island_impulses_test
