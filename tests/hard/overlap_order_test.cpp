// Balls on a line, by method overlap: they keep their order at every mass ratio, and what passes
// between two steps is counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "carom/simulation.hpp"
#include "support/random_numbers.hpp"

namespace carom::overlap_order_test {
namespace {

Ball disk(double x, double y, double mass = 1) {
  Ball ball{{x, y}};
  ball.mass = mass;
  return ball;
}

Scene box(const std::vector<Ball>& balls) {
  Scene scene;
  scene.box.width = 100;
  scene.box.height = 60;
  scene.effects.walls = Walls{0.5};
  scene.effects.collisions = Collisions{0.5};
  scene.balls = balls;
  scene.solver.method = Method::overlap;
  scene.workers = 1;
  return scene;
}

// Two to six balls of masses over four to eight decades, in a channel that just holds them.  Even
// with all of the energy the lightest would move no farther in a step than the smallest radius.
Scene line(std::uint64_t seed) {
  test::RandomNumbers random(seed);
  const double decades = 4.0 + 2 * random.below(3);
  std::vector<Ball> balls;
  double end = 0.2;
  double energy = 0;
  double lightest = std::numeric_limits<double>::infinity();
  for (int count = 2 + random.below(5); count > 0; --count) {
    const double radius = random.below(2) == 0 ? 0.3 : 0.5;
    Ball ball = disk(end + radius, 30, std::pow(10, random.between(-decades / 2, decades / 2)));
    ball.radius = radius;
    if (random.below(2) == 0) ball.velocity.x() = random.between(-5, 5);
    energy += ball.mass * ball.velocity.squaredNorm() / 2;
    lightest = std::min(lightest, ball.mass);
    end = ball.position.x() + radius + 0.5 * random.below(3);
    balls.push_back(ball);
  }
  const double fastest = std::sqrt(2 * energy / lightest);
  for (Ball& ball : balls) ball.velocity *= fastest > 0 ? 0.3 * 240 / fastest : 0;
  Scene scene = box(balls);
  scene.box.width = end + 0.2;
  const double restitutions[] = {0, 0.5, 0.9, 0.99, 1};
  scene.effects.collisions->restitution = restitutions[random.below(5)];
  scene.effects.walls->restitution = random.below(2) == 0 ? 1 : 0.5;
  return scene;
}

// Seen to fail: a light ball that was moved out of a heavy one into another hit that one in the
// next step only, so that heavy balls came together around it; seven of these lines lost their
// order, and said nothing.
TEST(OverlapOrder, ALineKeepsItsOrderAtEveryMassRatio) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE(seed);
    Simulation simulation(line(seed));
    simulation.advance_to(10);
    const std::vector<Ball> end = simulation.state();
    for (std::size_t k = 1; k < end.size(); ++k) {
      EXPECT_LT(end[k - 1].position.x(), end[k].position.x()) << k;
    }
    const Measurements measured = simulation.measure();
    EXPECT_EQ(measured.missed_hits, 0U);
    EXPECT_LE(measured.relative_energy_error(), 1e-11);
  }
}

// Each goes from its place to that of the other in one step.
// Seen to fail where a ball is looked for only where it is after the step.
TEST(OverlapOrder, TwoFastBallsThatChangePlacesAreOneMissedHit) {
  std::vector<Ball> balls{disk(40, 30), disk(43, 30)};
  balls[0].velocity.x() = 3.5 * 240;
  balls[1].velocity.x() = -3.5 * 240;
  Simulation simulation(box(balls));
  simulation.advance_to(1.0 / 240);
  EXPECT_EQ(simulation.measure().missed_hits, 1U);
}

// A fast ball passes another one between two steps: it is counted whatever they weigh.
TEST(OverlapOrder, HitsThatAreMissedAreCountedAtEveryMassRatio) {
  for (const double mass : {1.0, 1e3, 1e6}) {
    std::vector<Ball> balls{disk(50, 30), disk(40, 30, mass)};
    balls[1].velocity.x() = 15 * 240;
    Scene scene = box(balls);
    Simulation simulation(scene);
    simulation.advance_to(2.0 / 240);
    EXPECT_GT(simulation.measure().missed_hits, 0U) << mass;
  }
}

// A light ball between two heavy ones that come together goes to and fro until they turn: balls on
// a line keep their order as long as none moves farther in a step than the two reach.
// Seen to fail: where its impacts are taken two at a time, and end unfinished; out of order from
// masses of 1 : 1e4 on, and none counted.
TEST(OverlapOrder, ALightBallBetweenHeavyOnesStaysThere) {
  for (const double mass : {1e2, 1e4, 1e6}) {
    for (const double e : {1.0, 0.9, 0.5, 0.0}) {
      for (const double speed : {0.1, 1.0}) {
        if (mass * speed > 1e5 && e > 0.5) continue;  // the light one crosses them in a step
        std::vector<Ball> balls{disk(41, 30, mass), disk(43, 30, 1), disk(45, 30, mass)};
        balls[0].velocity.x() = speed;
        balls[2].velocity.x() = -speed;
        Scene scene = box(balls);
        scene.effects.collisions->restitution = e;
        Simulation simulation(scene);
        const double energy = simulation.measure().energy_initial;
        simulation.advance_to(20);
        const std::vector<Ball> end = simulation.state();
        EXPECT_LT(end[0].position.x(), end[1].position.x()) << mass << ' ' << e << ' ' << speed;
        EXPECT_LT(end[1].position.x(), end[2].position.x()) << mass << ' ' << e << ' ' << speed;
        EXPECT_NEAR(simulation.measure().momentum_final.x(), 0, 1e-9 * mass * speed);
        EXPECT_LE(simulation.measure().energy_final, energy * (1 + 1e-12));
      }
    }
  }
}

// Two that go past each other in a step, and overlap after it, meet.
// Seen to fail where they meet as they lie after the step.
TEST(OverlapOrder, BallsThatPassEachOtherInAStepBounce) {
  std::vector<Ball> balls{disk(41, 30), disk(42.1, 30)};
  balls[0].velocity.x() = 1.75 * 240;
  Scene scene = box(balls);
  scene.effects.collisions->restitution = 1;
  Simulation simulation(scene);
  simulation.advance_to(1.0 / 240);
  const std::vector<Ball> end = simulation.state();
  EXPECT_NEAR(end[0].velocity.x(), 0, 1e-9);
  EXPECT_NEAR(end[1].velocity.x(), 1.75 * 240, 1e-9);
  EXPECT_GE(end[1].position.x(), end[0].position.x() + 1 - 1e-9);
}

}  // namespace
}  // namespace carom::overlap_order_test
