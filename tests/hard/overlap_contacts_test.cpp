// Contacts that last, by method overlap: the closed forms of a uniform disk that rolls and slips,
// and what stands or lies for good.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "carom/simulation.hpp"
#include "support/known_scene.hpp"
#include "support/scenes.hpp"

namespace carom::overlap_contacts_test {
namespace {

using test::after;

constexpr double kGravity = 9.81;

Ball disk(double x, double y, double mass = 1) {
  Ball ball{{x, y}};
  ball.mass = mass;
  return ball;
}

Scene box(const std::vector<Ball>& balls, const Vec2& gravity = {0, -kGravity}) {
  Scene scene;
  scene.box.width = 100;
  scene.box.height = 60;
  scene.effects.walls = Walls{0.5};
  scene.effects.collisions = Collisions{0.5};
  scene.effects.gravity = Gravity{gravity};
  scene.balls = balls;
  scene.solver.method = Method::overlap;
  scene.workers = 1;
  return scene;
}

Scene rough(Scene scene, double friction) {
  scene.effects.friction = Friction{friction, friction};
  return scene;
}

// Layers on ice in a box that is periodic along it: nothing holds them, together they slide by
// g_x t^2 / 2, whatever of a heap a step leaves unsolved.
// Seen to fail: 3 columns of 30 went .998 of that at 1e-6, and .16 where heaps were solved to
// 2^-14.
TEST(OverlapContacts, LayersSlideOnTiltedIceByHalfOfGTSquared) {
  constexpr int kWide = 3;
  constexpr double kRoom = 1.0000001;
  for (const double tilt : {1e-4, 1e-6}) {
    std::vector<Ball> balls;
    for (int k = 0; k < 30 * kWide; ++k) {
      const int row = k / kWide;
      const double x = std::fmod(k % kWide + 0.5 * (row % 2), kWide) + 0.25;
      balls.push_back(disk(x, 0.5 + row * std::sqrt(0.75) * kRoom));
    }
    Scene scene = box(balls, {tilt * kGravity, -kGravity});
    scene.box.width = kWide * kRoom;
    scene.box.periodic = {true, false};
    double slid = 0;
    double speed = 0;
    const std::vector<Ball> end = after(scene, 4);
    for (std::size_t k = 0; k < balls.size(); ++k) {
      const double way = end[k].position.x() - balls[k].position.x();
      slid += std::remainder(way, scene.box.width) / static_cast<double>(balls.size());
      speed += end[k].velocity.x() / static_cast<double>(balls.size());
    }
    const double expected = tilt * kGravity * 8;
    EXPECT_NEAR(slid, expected, 1e-4 * expected) << tilt;
    EXPECT_NEAR(speed, expected / 2, 1e-6 * expected) << tilt;
  }
}

// Initially a spin w: slips with mu g until v = r w, then rolls at w r / 3.
TEST(OverlapContacts, ASpinningBallSlipsThenRolls) {
  const double mu = 0.2;
  Ball start = disk(20, 0.5);
  start.spin = -20;
  const double rolls = 10 / (3 * mu * kGravity);
  const double speed = 10.0 / 3;
  const Ball now = after(rough(box({start}), mu), 3)[0];
  EXPECT_NEAR(now.velocity.x(), speed, 1e-9);
  EXPECT_NEAR(now.spin, -speed / 0.5, 1e-9);
  EXPECT_NEAR(now.position.x(), 20 + mu * kGravity * rolls * rolls / 2 + speed * (3 - rolls), 1e-3);
  EXPECT_EQ(now.position.y(), 0.5);
}

// Thrown flat without spin it ends rolling with 2/3 of its speed, on an elastic floor too.
TEST(OverlapContacts, ABallThrownFlatEndsRolling) {
  Ball start = disk(5, 0.5);
  start.velocity.x() = 3;
  Scene scene = rough(box({start}), 0.4);
  scene.effects.walls->restitution = 1;
  scene.effects.collisions->restitution = 1;
  const Ball now = after(scene, 6)[0];
  EXPECT_NEAR(now.velocity.x(), 2, 1e-9);
  EXPECT_NEAR(now.spin, -4, 1e-9);
  EXPECT_EQ(now.position.y(), 0.5);
}

// Side by side both roll with 2/3 of the pull; the error is of first order in the step.
TEST(OverlapContacts, TwoBallsThatTouchRollDownASlope) {
  const double pull = kGravity / 10;
  const double way = pull / 3 * 16;
  double coarse = 0;
  for (const double rate : {240.0, 960.0}) {
    Scene scene = rough(box({disk(5, 0.5), disk(6, 0.5)}, {pull, -kGravity}), 0.4);
    scene.solver.step = 1 / rate;
    const std::vector<Ball> now = after(scene, 4);
    double worst = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      worst = std::max(worst, std::abs(now[k].position.x() - 5 - double(k) - way));
      EXPECT_NEAR(now[k].velocity.x(), 2 * pull / 3 * 4, 1e-3);
    }
    EXPECT_LT(worst, 1e-3);
    if (rate == 240) coarse = worst;
    if (rate == 960) {
      EXPECT_LT(worst, coarse / 2);
    }
  }
}

TEST(OverlapContacts, WhatIsPulledALittleMoves) {
  for (const double tilt : {1e-4, 1e-6}) {
    const double pull = tilt * kGravity;
    const auto now = after(box({disk(5, 0.5), disk(5, 1.5)}, {pull, -kGravity}), 4);
    for (const Ball& ball : now) {
      EXPECT_NEAR(ball.velocity.x(), 4 * pull, 1e-6 * pull);
      EXPECT_NEAR((ball.position.x() - 5) / (8 * pull), 1, 1e-3);
    }
  }
  // Pressed against the left wall, and pulled down it a little.
  const std::vector<double> heights{9, 7, 5};
  std::vector<Ball> balls;
  for (const double y : heights) balls.push_back(disk(0.5, y));
  const auto now = after(box(balls, {-kGravity, -1e-6}), 4);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(now[k].position.y() - heights[k], -8e-6, 1e-9);
  }
}

void expect_still(const Scene& scene, double time) {
  Simulation simulation(scene);
  simulation.advance_to(time);
  const std::vector<Ball> now = simulation.state();
  for (std::size_t k = 0; k < now.size(); ++k) {
    EXPECT_LT((now[k].position - scene.balls[k].position).norm(), 1e-6 * now[k].radius);
    EXPECT_EQ(now[k].velocity, (Vec2{0, 0}));
    EXPECT_EQ(now[k].spin, 0);
  }
}

TEST(OverlapContacts, ATowerOfFiftyStands) {
  std::vector<Ball> balls;
  for (int k = 0; k < 50; ++k) balls.push_back(disk(50, 0.5 + k));
  expect_still(box(balls), 60);
}

// One island, of more balls than the stack of a worker has room to order.
TEST(OverlapContacts, AWallOfFourThousandBallsStands) {
  std::vector<Ball> balls;
  for (int column = 0; column < 62; ++column) {
    for (int row = 0; row < 64; ++row) {
      balls.push_back(disk(0.5 + column, 0.5 + row));
      balls.back().velocity.y() = row == 0 ? 0 : -1e-3;
    }
  }
  Scene scene = box(balls);
  scene.box = {62, 66};
  Simulation simulation(scene);
  simulation.advance_to(4 * scene.solver.step);
  const std::vector<Ball> now = simulation.state();
  for (std::size_t i = 0; i < now.size(); ++i) {
    EXPECT_NEAR(now[i].position.y(), scene.balls[i].position.y(), 1e-4);
  }
}

TEST(OverlapContacts, APyramidOfTenRowsStandsByFriction) {
  std::vector<Ball> balls;
  for (int row = 0; row < 10; ++row) {
    for (int k = 0; k < 10 - row; ++k) {
      balls.push_back(disk(20 + k + row * 0.5, 0.5 + row * std::sqrt(0.75)));
    }
  }
  expect_still(rough(box(balls), 0.8), 60);
}

// Three balls between two fixed ones: the slopes of the thrust are as 3 : 1, so that an arch of
// these slopes carries itself, and one of equal slopes needs friction.
TEST(OverlapContacts, AnArchStandsOnTheLineOfItsThrustOrByFriction) {
  const double high = std::acos(-1.0) / 9;
  const double low = std::atan(3 * std::tan(high));
  const auto arch = [](double first, double second) {
    const double x = std::cos(first) + std::cos(second);
    std::vector<Ball> balls{disk(50 - x, 5), disk(50 - std::cos(second), 5 + std::sin(first)),
                            disk(50, 5 + std::sin(first) + std::sin(second)),
                            disk(50 + std::cos(second), 5 + std::sin(first)), disk(50 + x, 5)};
    balls.front().fixed = balls.back().fixed = true;
    return balls;
  };
  expect_still(rough(box(arch(low, high)), 0.5), 20);
  expect_still(rough(box(arch(0.6, 0.6)), 0.8), 20);
  const std::vector<Ball> now = after(box(arch(0.6, 0.6)), 2);
  EXPECT_LT(now[2].position.y(), 5);
}

TEST(OverlapContacts, HeavyAndLightInTurnRestForEver) {
  for (const double mass : {1e2, 1e4}) {
    std::vector<Ball> balls;
    for (int k = 0; k < 4; ++k) balls.push_back(disk(5, 0.5 + k, k % 2 == 0 ? 1 : mass));
    expect_still(box(balls), 20);
  }
}

// Loose balls fall and come to rest; what slides is solved to a part of its slip.
TEST(OverlapContacts, BallsThatSlideOnEachOtherDoNotSink) {
  for (const auto& [friction, seed] : {std::pair{0.1, 6U}, std::pair{0.3, 4U}}) {
    Scene scene = rough(box({}), friction);
    scene.box.width = 15.18;
    scene.box.height = 3 * scene.box.width;
    scene.effects.walls->restitution = scene.effects.collisions->restitution = 0.3;
    Fill& fill = scene.fills.emplace_back();
    fill.count = 200;
    fill.radius = 0.4;
    fill.temperature = 0.1;
    scene.seed = seed;
    scene.solver.step = 1.0 / 60;
    Simulation simulation(scene);
    simulation.advance_to(6);
    EXPECT_LT(simulation.measure().max_overlap, 1e-3) << friction << " " << seed;
  }
}

// Where nothing is lost nothing is: heavy and light balls fall on each other and stay in line.
TEST(OverlapContacts, ElasticBallsOnALineKeepTheirOrderAndEnergy) {
  for (const double mass : {1.0, 100.0, 1e4}) {
    std::vector<Ball> balls;
    for (int k = 0; k < 4; ++k) balls.push_back(disk(5, 0.5 + 1.1 * k, k % 2 == 0 ? 1 : mass));
    Scene scene = box(balls);
    scene.effects.walls->restitution = scene.effects.collisions->restitution = 1;
    Simulation simulation(scene);
    simulation.advance_to(10);
    const std::vector<Ball> now = simulation.state();
    for (std::size_t k = 1; k < now.size(); ++k) {
      EXPECT_GT(now[k].position.y(), now[k - 1].position.y());
    }
    EXPECT_LE(simulation.measure().energy_final, simulation.measure().energy_initial * (1 + 1e-9));
  }
}

// What lies and is struck wakes at the end of that step; once, while it moves.
TEST(OverlapContacts, TheRecordTellsWhoIsWoken) {
  Simulation simulation(box({disk(5, 0.5), disk(5, 5), disk(20, 0.5)}));
  simulation.record_impacts(true);
  const double step = 1.0 / 240;
  const double struck = std::sqrt(2 * 3.5 / kGravity);
  simulation.advance_to(struck + 2 * step);
  std::vector<Impact> woken;
  for (const Impact& impact : simulation.take_impacts(true)) {
    if (impact.kind == ImpactKind::wake) woken.push_back(impact);
  }
  ASSERT_EQ(woken.size(), 1U);
  EXPECT_EQ(woken[0].a, 0U);
  EXPECT_EQ(woken[0].b, Impact::kNoBall);
  EXPECT_NEAR(woken[0].time, struck, step);
  EXPECT_EQ(woken[0].energy_lost, 0);
}

// Balls that cross the box many times in a step are pushed through walls that were not near: what
// brings them back inside makes no energy.
TEST(OverlapContacts, FastBallsOfUnequalMassGainNoEnergyAtWalls) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Scene scene = test::walled_gas(4, 4, 0.8, seed);
    scene.effects.walls->restitution = scene.effects.collisions->restitution = 1;
    scene.effects.gravity = Gravity{{0.25, -9.75}};
    scene.solver.step = 1.0 / 60;
    std::mt19937_64 engine(seed);
    for (Ball& ball : scene.balls) {
      ball.velocity *= 1e4;
      ball.radius = test::uniform(engine) < 0.5 ? 0.5 : 0.25;
      ball.mass = test::uniform(engine) < 0.3 ? 100 : 1;
      ball.fixed = test::uniform(engine) < 0.25;
      if (ball.fixed) ball.velocity = {0, 0};
    }
    Simulation simulation(scene);
    const double energy = simulation.measure().energy_initial;
    simulation.advance_to(1);
    EXPECT_LE(simulation.measure().energy_final, energy * (1 + 1e-12)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace carom::overlap_contacts_test
