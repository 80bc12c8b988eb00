// Piles of method overlap, as large as its goals name.
#include <gtest/gtest.h>

#include "carom/simulation.hpp"
#include "support/scenes.hpp"

namespace carom::overlap_pile_test {
namespace {

// What falls loses energy and never gains any, and lies still in the end.
void falls_asleep(const Scene& scene) {
  Simulation simulation(scene);
  double energy = simulation.measure().energy_initial;
  const double scale = energy;
  for (double time = 0.5; time <= scene.duration; time += 0.5) {
    simulation.advance_to(time);
    const double now = simulation.measure().energy_final;
    EXPECT_LE(now, energy + 1e-12 * scale) << "at " << time;
    energy = now;
  }
  // One that rolls on the floor and touches no other rolls on for ever.
  for (const Ball& ball : simulation.state()) {
    if (ball.velocity.y() == 0 && ball.spin == -ball.velocity.x() / ball.radius) continue;
    ASSERT_EQ(ball.velocity, Vec2(0, 0));
    ASSERT_EQ(ball.spin, 0);
  }
  EXPECT_LT(simulation.measure().max_overlap, 1e-3);
  EXPECT_LT(simulation.measure().relative_energy_error(), 1e-12);
}

TEST(OverlapPileLong, AThousandBallsFallAsleepWithSmallOverlaps) {
  Scene scene = test::pile(1000, 0.2);
  scene.solver.step = 1.0 / 60;
  scene.duration = 40;
  falls_asleep(scene);
}

TEST(OverlapPileLong, TwoHundredBallsThatRubFallAsleepWithSmallOverlaps) {
  Scene scene = test::pile(200, 0.2, 14);
  scene.effects.friction = Friction{0.3, 0.3};
  scene.solver.step = 1.0 / 60;
  scene.duration = 40;
  falls_asleep(scene);
}

}  // namespace
}  // namespace carom::overlap_pile_test
