#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "solvers/event/solver.hpp"
#include "support/advance.hpp"

namespace carom::event_hard_test {
namespace {

Ball ball(double x, double y, double vx, double vy, double radius = 0.5, double mass = 1) {
  Ball result;
  result.position = {x, y};
  result.velocity = {vx, vy};
  result.radius = radius;
  result.mass = mass;
  return result;
}

Scene elastic(double width, double height) {
  Scene scene;
  scene.box.width = width;
  scene.box.height = height;
  scene.effects.walls = Walls{};
  scene.effects.collisions = Collisions{};
  return scene;
}

Measurements run_to(Solver& solver, double time) {
  test::advance(solver, time);
  Measurements measured;
  solver.count(measured);
  return measured;
}

// G. Galperin, Playing pool with pi, Regul. Chaotic Dyn. 8 (2003) 375.
TEST(EventHard, a_heavy_ball_a_light_one_and_a_wall_count_the_digits_of_pi) {
  const std::vector<std::uint64_t> digits{3, 31, 314, 3141, 31415, 314159};
  double mass = 1;
  for (const std::uint64_t expected : digits) {
    Scene scene = elastic(100, 2);
    const auto solver = std::make_unique<EventSolver>(
        scene, std::vector<Ball>{ball(4, 1, 0, 0), ball(8, 1, -1, 0, 0.5, mass)});
    const Measurements measured = run_to(*solver, 50);
    EXPECT_EQ(measured.ball_ball + measured.ball_wall, expected) << "mass " << mass;
    mass *= 100;
  }
}

TEST(EventHard, a_bullet_hits_a_ball_and_a_wall_exactly_once) {
  Scene scene = elastic(100, 4);
  const auto solver = std::make_unique<EventSolver>(
      scene, std::vector<Ball>{ball(1, 2, 3e7, 0), ball(60, 2, 0, 0, 0.5, 1e9)});
  const Measurements measured = run_to(*solver, (58.0 + 50.0) / 3e7);
  EXPECT_EQ(measured.ball_ball, 1U);
  EXPECT_EQ(measured.ball_wall, 0U);
  EXPECT_LT(solver->state()[0].velocity.x(), 0);
  EXPECT_EQ(run_to(*solver, (58.0 + 59.0) / 3e7).ball_wall, 1U);
}

Scene crystal(unsigned columns, unsigned rows, double packing) {
  const double spacing = std::sqrt(2 / (std::sqrt(3.0) * 4 * packing / 3.141592653589793));
  Scene scene = elastic(columns * spacing, rows * spacing * std::sqrt(0.75));
  scene.effects.walls.reset();
  scene.box.periodic = {true, true};
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  Vec2 drift{0, 0};
  for (unsigned r = 0; r < rows; ++r) {
    for (unsigned c = 0; c < columns; ++c) {
      scene.balls.push_back(ball((c + (r % 2 == 0 ? 0.25 : 0.75)) * spacing,
                                 (r + 0.5) * spacing * std::sqrt(0.75), normal(random),
                                 normal(random)));
      drift += scene.balls.back().velocity;
    }
  }
  for (Ball& b : scene.balls) b.velocity -= drift / static_cast<double>(scene.balls.size());
  return scene;
}

// 0.90 of the plane covered, where 0.9069 is the most there can be.
TEST(EventHard, balls_nearly_jammed_do_not_overlap_and_keep_their_energy) {
  const Scene scene = crystal(14, 14, 0.90);
  const auto solver = std::make_unique<EventSolver>(scene, scene.balls);
  const double energy = solver->energy();
  Measurements measured;
  for (double time = 1; measured.ball_ball < 200'000; ++time) measured = run_to(*solver, time);
  EXPECT_LE(measured.max_overlap, 1e-13);
  EXPECT_NEAR(solver->energy() / energy, 1, 1e-12);
  EXPECT_LE(solver->momentum().norm(), 1e-12);
}

// Z = P A / (N k T) from the momentum that impacts pass on would need every impact's; their number
// says the same: the collision rate is (Z - 1) 2 / sqrt(pi) N / sigma sqrt(k T / m), with
// k T = E / (N - 1) at zero momentum.
// Source: J. Kolafa, M. Rottner, Mol. Phys. 104 (2006) 3435: Z at packing 0.471239 is 3.663691.
TEST(EventHard, a_periodic_gas_collides_as_often_as_its_equation_of_state_says) {
  const Scene scene = crystal(16, 16, 0.471239);
  const auto solver = std::make_unique<EventSolver>(scene, scene.balls);
  const double n = 256;
  const double temperature = solver->energy() / (n - 1);
  const double settled = 20;
  const double end = 170;
  const double before = static_cast<double>(run_to(*solver, settled).ball_ball);
  const double hits = static_cast<double>(run_to(*solver, end).ball_ball) - before;
  const double rate = hits / (end - settled) / n;
  const double z = 1 + rate * std::sqrt(3.141592653589793) / 2 / std::sqrt(temperature);
  EXPECT_NEAR(z, 3.663691, 0.02);
}

}  // namespace
}  // namespace carom::event_hard_test
