// Statics that can be written down.
#include "accuracy/equilibrium.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "accuracy/nonnegative_least_squares.hpp"

namespace carom::accuracy::equilibrium_test {
namespace {

constexpr double kRight = 1e-9;

Ball disk(double x, double y, double radius = 0.5, double mass = 1) {
  Ball ball;
  ball.position = {x, y};
  ball.radius = radius;
  ball.mass = mass;
  return ball;
}

Effects under(const Vec2& gravity) {
  Effects effects;
  effects.walls = Walls{};
  effects.collisions = Collisions{};
  effects.gravity = Gravity{gravity};
  return effects;
}

const Box kBox{};

TEST(Equilibrium, OneBallIsCarriedByTheFloorAloneWhereGravityIsAcrossIt) {
  const Effects effects = under({0, -9.81});
  EXPECT_NEAR(equilibrium_residual({disk(5, 0.5)}, kBox, effects), 0, kRight);
  EXPECT_NEAR(equilibrium_residual({disk(5, 0.5 + 0.9e-3 * 0.5)}, kBox, effects), 0, kRight);
  EXPECT_EQ(equilibrium_residual({disk(5, 0.5 + 1.1e-3 * 0.5)}, kBox, effects), 1);
  EXPECT_EQ(equilibrium_residual({disk(5, 5)}, kBox, effects), 1);
  // A slope carries the part across it.
  EXPECT_NEAR(equilibrium_residual({disk(5, 0.5)}, kBox, under({3, -4})), 0.6, kRight);
  // A wall pushes and never pulls.
  EXPECT_NEAR(equilibrium_residual({disk(5, 0.5)}, kBox, under({0, 4})), 1, kRight);
  EXPECT_EQ(equilibrium_residual({disk(5, 5)}, kBox, under({0, 0})), 0);
}

TEST(Equilibrium, ABallOnASlopeStaysWithNoFrictionAsItRolls) {
  // Friction turns it: force and torque cannot both vanish.  The best of both is found by hand:
  // along the slope f + s and about the centre -f are left of a pull s, so f = -s / 2.
  Effects effects = under({3, -4});
  effects.friction = Friction{1, 1};
  EXPECT_NEAR(equilibrium_residual({disk(5, 0.5)}, kBox, effects), 0.6 / std::sqrt(2), kRight);
}

TEST(Equilibrium, ATriangleStandsFromTheFrictionThatTheorySays) {
  // Two disks that touch each other and the floor, one on top: with mu at least tan 15 degrees,
  // between balls and at the floor, it stands.
  const double r = 0.5;
  const std::vector<Ball> balls{disk(5, r), disk(5 + 2 * r, r),
                                disk(5 + r, r + std::sqrt(3.0) * r)};
  Effects effects = under({0, -9.81});
  const double least = std::tan(std::numbers::pi / 12);
  effects.friction = Friction{least * 1.001, least * 1.001};
  EXPECT_NEAR(equilibrium_residual(balls, kBox, effects), 0, kRight);
  effects.friction = Friction{least * 0.999, least * 0.999};
  EXPECT_GT(equilibrium_residual(balls, kBox, effects), 1e-5);
  effects.friction.reset();
  EXPECT_GT(equilibrium_residual(balls, kBox, effects), 0.1);
}

TEST(Equilibrium, TowersAndHeavyBallsOnLightOnesStand) {
  std::vector<Ball> balls;
  for (int i = 0; i < 50; ++i) balls.push_back(disk(5, 0.1 + 0.2 * i, 0.1, i % 2 == 0 ? 1 : 1e4));
  Box box;
  box.height = 11;
  EXPECT_NEAR(equilibrium_residual(balls, box, under({0, -9.81})), 0, kRight);
  balls[49].position = {5.001, balls[49].position.y()};
  EXPECT_GT(equilibrium_residual(balls, box, under({0, -9.81})), 1e-6);
}

TEST(Equilibrium, FixedBallsCarryAndPeriodicSidesAreNone) {
  std::vector<Ball> balls{disk(5, 5), disk(5, 6)};
  balls[0].fixed = true;
  EXPECT_NEAR(equilibrium_residual(balls, kBox, under({0, -9.81})), 0, kRight);
  // Across a periodic side.
  Box box;
  box.periodic = {true, false};
  const double r = 0.5;
  std::vector<Ball> bridge{disk(0.5, 5), disk(19.5, 5), disk(0, 5 + std::sqrt(3.0) * r)};
  bridge[0].fixed = bridge[1].fixed = true;
  EXPECT_NEAR(equilibrium_residual(bridge, box, under({0, -9.81})), 0, kRight);
  EXPECT_NEAR(equilibrium_residual(bridge, kBox, under({0, -9.81})), 0, kRight)
      << "between solid walls one disk and the wall carry it";
}

TEST(LeastSquaresOfForces, TheBestForcesAreNotNegative) {
  // |(f - 1, g + 2)| with f, g >= 0 is least at f = 1, g = 0.
  EXPECT_NEAR(least_residual({2, 2, {{0, 0, 1}, {1, 1, 1}}, {1, -2}}), 2, kRight);
  EXPECT_NEAR(least_residual({2, 1, {{0, 0, 1}, {1, 0, 1}}, {1, 0}}), std::sqrt(0.5), kRight);
  // More columns than rows: many solutions, no residual.
  EXPECT_NEAR(least_residual({1, 3, {{0, 0, 1}, {0, 1, 2}, {0, 2, -1}}, {5}}), 0, kRight);
  EXPECT_EQ(least_residual({2, 0, {}, {3, 4}}), 5);
}

}  // namespace
}  // namespace carom::accuracy::equilibrium_test
