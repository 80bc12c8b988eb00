// A ball in a contact that lasts meets something else: it bounces with its restitution, by both
// methods.
#include <gtest/gtest.h>

#include <cmath>

#include "carom/simulation.hpp"

namespace carom::contact_bounce_test {
namespace {

constexpr double kGravity = 9.81;
constexpr double kReach = 1.5;  // of the two radii
constexpr double kFrom = 0.3;   // angles from straight above
constexpr double kTo = 0.6;

// A ball slides from rest down the side of a fixed one, without friction, until it meets a wall.
Scene slide(Method method, double restitution, double mass) {
  Scene scene;
  scene.box.width = 5 + kReach * std::sin(kTo) + 0.5;
  scene.box.height = 10;
  scene.effects.walls = Walls{restitution};
  scene.effects.collisions = Collisions{restitution};
  scene.effects.gravity = Gravity{{0, -kGravity}};
  Ball fixed{{5, 1}};
  fixed.radius = 1;
  fixed.fixed = true;
  Ball ball{{5 + kReach * std::sin(kFrom), 1 + kReach * std::cos(kFrom)}};
  ball.mass = mass;
  scene.balls = {fixed, ball};
  scene.solver.method = method;
  scene.solver.step = 1.0 / 3840;
  scene.workers = 1;
  return scene;
}

// It has no way but back up the side that it came from: at e times the speed of its fall by
// h = reach (cos from - cos to), so that (1 - e^2) m g h is lost, and up to e^2 h.
// Seen to fail where a step of method event held whatever would close in it as if it lay there, and
// all of m g h was lost.
TEST(ContactBounce, ABallThatSlidesIntoAWallLeavesItWithItsRestitution) {
  for (const Method method : {Method::event, Method::overlap}) {
    for (const double e : {0.3, 0.5, 0.8}) {
      SCOPED_TRACE(testing::Message() << (method == Method::event ? "event " : "overlap ") << e);
      const double mass = 2.5;
      const double height = kReach * (std::cos(kFrom) - std::cos(kTo));
      const double low = 1 + kReach * std::cos(kTo);
      Simulation simulation(slide(method, e, mass));
      double time = 0;
      while (simulation.measure().ball_wall == 0 && time < 5) simulation.advance_to(time += 0.01);
      ASSERT_LT(time, 5);
      const double lost = (1 - e * e) * mass * kGravity * height;
      const double exact = method == Method::event ? 2e-3 : 2e-2;
      EXPECT_NEAR(simulation.measure().energy_dissipated, lost, exact * lost);
      double highest = 0;
      double y = 0;
      while ((y = simulation.state()[1].position.y()) >= highest) {
        highest = y;
        simulation.advance_to(time += 0.002);
      }
      EXPECT_NEAR(highest - low, e * e * height, exact * height);
      EXPECT_LE(simulation.measure().relative_energy_error(), 1e-12);
      EXPECT_LE(simulation.measure().max_overlap, 1e-3);
    }
  }
}

}  // namespace
}  // namespace carom::contact_bounce_test
