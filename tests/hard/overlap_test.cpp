#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "carom/simulation.hpp"
#include "support/scenes.hpp"

// The expected values follow from conservation laws and from the set-up of each case.

namespace carom::overlap_test {
namespace {

using test::gas;
using test::pile;
using test::walled_gas;

double kinetic(const Simulation& simulation) {
  double sum = 0;
  for (const Ball& ball : simulation.state()) sum += ball.mass * ball.velocity.squaredNorm() / 2;
  return sum;
}

double deepest_overlap(const std::vector<Ball>& balls) {
  double deepest = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (std::size_t j = i + 1; j < balls.size(); ++j) {
      const double distance = (balls[i].position - balls[j].position).norm();
      deepest = std::max(deepest, balls[i].radius + balls[j].radius - distance);
    }
  }
  return deepest;
}

bool inside(const Scene& scene, const std::vector<Ball>& balls) {
  return std::all_of(balls.begin(), balls.end(), [&](const Ball& ball) {
    return ball.position.x() >= ball.radius && ball.position.y() >= ball.radius &&
           ball.position.x() <= scene.box.width - ball.radius &&
           ball.position.y() <= scene.box.height - ball.radius;
  });
}

Scene empty_box(double width, double height) {
  Scene scene;
  scene.box.width = width;
  scene.box.height = height;
  scene.effects.walls = Walls{};
  scene.solver.method = Method::overlap;
  scene.workers = 1;
  return scene;
}

TEST(Overlap, ABallThatBouncesTenThousandTimesKeepsItsEnergy) {
  Scene scene = empty_box(4, 4);
  scene.effects.gravity = Gravity{{0, -9.81}};
  scene.balls.push_back(Ball{{2, 1.5}});  // 1 m above the floor
  Simulation simulation(scene);
  const double energy = simulation.measure().energy_initial;
  double time = 0;
  while (simulation.measure().ball_wall < 10'000) {
    simulation.advance_to(time += 10);
    ASSERT_LT(time, 10'000) << "bounces: " << simulation.measure().ball_wall;
  }
  EXPECT_NEAR(simulation.measure().energy_final, energy, 1e-3 * energy);
  // Much better than that: a wall does no work at all.
  EXPECT_NEAR(simulation.measure().energy_final, energy, 1e-11 * energy);
}

TEST(Overlap, ABallThatBouncesOnAPegKeepsItsEnergy) {
  Scene scene = empty_box(4, 8);
  scene.effects.gravity = Gravity{{0, -9.81}};
  scene.effects.collisions = Collisions{};
  scene.balls.push_back(Ball{{2, 5}});
  Ball fixed_disk{{2, 1}};
  fixed_disk.fixed = true;
  scene.balls.push_back(fixed_disk);
  Simulation simulation(scene);
  const double energy = simulation.measure().energy_initial;
  simulation.advance_to(1000);
  EXPECT_GT(simulation.measure().ball_ball, 400U);
  EXPECT_NEAR(simulation.measure().energy_final, energy, 1e-9 * energy);
}

class Gas : public testing::TestWithParam<double> {};

TEST_P(Gas, EnergyNeverGrowsAndMomentumIsKeptOverAHundredThousandSteps) {
  Scene scene = gas(8, 8, GetParam());
  Simulation simulation(scene);
  const double energy = simulation.measure().energy_initial;
  simulation.advance_to(100'000.0 / 240);
  const Measurements after = simulation.measure();
  EXPECT_GT(after.ball_ball, 1000U);
  EXPECT_NEAR(after.energy_final, energy, 1e-12 * energy);
  EXPECT_NEAR((after.momentum_final - after.momentum_initial).norm(), 0,
              1e-12 * std::sqrt(64 * 2 * energy));
}

INSTANTIATE_TEST_SUITE_P(Overlap, Gas, testing::Values(0.05, 0.5, 0.85));

TEST(Overlap, ABulletNeverLeavesItsBox) {
  Scene scene = empty_box(20, 10);
  scene.effects.collisions = Collisions{};
  scene.balls.push_back(Ball{{3, 5}, {3e7, 1.1e7}});  // a million diameters in a frame
  scene.balls.push_back(Ball{{10, 5}});
  Simulation simulation(scene);
  const double energy = simulation.measure().energy_initial;
  for (int frame = 1; frame <= 200; ++frame) {
    simulation.advance_to(frame / 30.0);
    ASSERT_TRUE(inside(scene, simulation.state())) << "frame " << frame;
  }
  EXPECT_NEAR(simulation.measure().energy_final, energy, 1e-12 * energy);
}

TEST(Overlap, ATouchingCradleKeepsEnergyAndMomentum) {
  for (const std::size_t strikers : {1, 2, 3}) {
    Scene scene = empty_box(40, 4);
    scene.effects.collisions = Collisions{};
    for (std::size_t i = 0; i < 5; ++i)
      scene.balls.push_back(Ball{{20.0 + static_cast<double>(i), 2}});
    for (std::size_t i = 0; i < strikers; ++i) {
      scene.balls.push_back(Ball{{18.0 - static_cast<double>(i), 2}, {1, 0}});
    }
    Simulation simulation(scene);
    simulation.advance_to(8);
    const Measurements after = simulation.measure();
    EXPECT_LE(after.energy_final, after.energy_initial * (1 + 1e-12));
    EXPECT_NEAR(after.energy_final, after.energy_initial, 1e-12);
    EXPECT_NEAR(after.momentum_final.x(), static_cast<double>(strikers), 1e-12);
    EXPECT_EQ(after.momentum_final.y(), 0);
  }
}

TEST(Overlap, ABallAsTallAsItsBoxGlidesForEver) {
  for (const bool falling : {false, true}) {
    Scene scene = empty_box(20, 1);
    if (falling) scene.effects.gravity = Gravity{{0, -9.81}};
    scene.balls.push_back(Ball{{10, 0.5}, {1, 0}});
    Simulation simulation(scene);
    for (int k = 1; k <= 300; ++k) {
      const double time = k * 3.375;
      simulation.advance_to(time);
      const Ball ball = simulation.state().front();
      ASSERT_EQ(ball.position.y(), 0.5) << "at " << time;
      ASSERT_EQ(ball.velocity.y(), 0) << "at " << time;
      // Between walls 19 apart for its centre, its way is a straight one, folded.
      const double way = std::fmod(9.5 + time, 38);
      const double there = 0.5 + (way < 19 ? way : 38 - way);
      // Each bounce is seen up to a step late.
      const double late = scene.solver.step * (1 + std::floor((9.5 + time) / 19));
      ASSERT_NEAR(ball.position.x(), there, late + 1e-9) << "at " << time;
      ASSERT_GE(ball.position.x(), 0.5);
      ASSERT_LE(ball.position.x(), 19.5);
      ASSERT_EQ(std::abs(ball.velocity.x()), 1) << "at " << time;
    }
  }
}

TEST(Overlap, AHitIntoAnExactCornerReverses) {
  Scene scene = empty_box(10, 10);
  scene.balls.push_back(Ball{{5, 5}, {1, 1}});
  Simulation simulation(scene);
  simulation.advance_to(6);
  EXPECT_EQ(simulation.state().front().velocity, Vec2(-1, -1));
}

// A thousand are in long/overlap_pile_test.cpp.
TEST(Overlap, TwoHundredBallsPileUpWithSmallOverlaps) {
  const Scene scene = pile(200, 0.2, 14);
  Simulation simulation(scene);
  double energy = simulation.measure().energy_initial;
  const double drop = energy;
  for (double time = 0.25; time <= 6; time += 0.25) {
    simulation.advance_to(time);
    const double now = simulation.measure().energy_final;
    EXPECT_LE(now, energy * (1 + 1e-12)) << "at " << time;
    energy = now;
  }
  EXPECT_TRUE(inside(scene, simulation.state()));
  EXPECT_LT(deepest_overlap(simulation.state()), 1e-3 * 0.5);
  EXPECT_LT(kinetic(simulation), 1e-3 * (drop - energy));
}

TEST(Overlap, AnElasticGasUnderGravityKeepsItsEnergy) {
  Scene scene = walled_gas(12, 12, 0.6);
  scene.effects.gravity = Gravity{{0, -9.81}};
  Ball fixed_disk{{0.5, scene.box.height + 1}};
  fixed_disk.fixed = true;
  scene.box.height += 2;
  scene.balls.push_back(fixed_disk);
  Simulation simulation(scene);
  const double energy = simulation.measure().energy_initial;
  simulation.advance_to(30);
  EXPECT_GT(simulation.measure().ball_ball, 1000U);
  EXPECT_NEAR(simulation.measure().energy_final, energy, 1e-10 * energy);
}

TEST(Overlap, TinyNumbersAndCoincidentCentresGiveNumbers) {
  for (const double offset : {0.0, 1e-310, 1e-200}) {
    Scene scene = empty_box(10, 10);
    scene.effects.collisions = Collisions{};
    scene.balls.push_back(Ball{{5, 5}, {1, 0}});
    scene.balls.push_back(Ball{{5, 5 + offset}, {-1, 0}});
    scene.box.origin = Box::Origin::center;
    for (Ball& ball : scene.balls) ball.position -= Vec2{5, 5};
    Simulation simulation(scene);
    simulation.advance_to(2);
    for (const Ball& ball : simulation.state()) {
      EXPECT_TRUE(ball.position.allFinite() && ball.velocity.allFinite());
    }
    EXPECT_NEAR(kinetic(simulation), 1, 1e-12);
  }
}

}  // namespace
}  // namespace carom::overlap_test
