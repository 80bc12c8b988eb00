// Inelastic collapse: impacts follow each other ever faster, until many share one tick of time.
// What then is resolved together must not depend on the order of the balls or on the workers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "carom/session.hpp"

namespace carom::event_collapse_test {
namespace {

constexpr int kColumns = 4;

Scene dense_and_dissipative(unsigned seed, double restitution) {
  constexpr double kPacking = 0.7;
  const double side = kColumns * std::sqrt(std::numbers::pi / (4 * kPacking));
  Scene scene;
  scene.box.width = side;
  scene.box.height = side;
  scene.box.periodic = {true, true};
  scene.effects.collisions = Collisions{restitution};
  scene.solver.method = Method::event;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> draw(-1000, 1000);
  for (int row = 0; row < kColumns; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      Ball ball;
      ball.position = {(column + 0.5) * side / kColumns, (row + 0.5) * side / kColumns};
      ball.velocity = {draw(random) / 1000.0, draw(random) / 1000.0};
      ball.radius = 0.5;
      scene.balls.push_back(ball);
    }
  }
  return scene;
}

struct End {
  std::vector<Ball> balls;
  std::uint64_t impacts = 0;
  std::uint64_t resting = 0;  ///< contacts
};

End run(Scene scene, std::size_t workers) {
  constexpr double kTime = 12;
  scene.workers = workers;
  Session session(scene);
  session.advance_clock_to(kTime);
  const Measurements measured = session.simulation().measure();
  return {session.simulation().state(), measured.ball_ball, measured.resting_contacts};
}

void expect_same(const End& one, const End& other, const std::string& name) {
  EXPECT_EQ(one.impacts, other.impacts) << name;
  ASSERT_EQ(one.balls.size(), other.balls.size());
  for (std::size_t i = 0; i < one.balls.size(); ++i) {
    EXPECT_EQ(one.balls[i].position, other.balls[i].position) << name << ", ball " << i;
    EXPECT_EQ(one.balls[i].velocity, other.balls[i].velocity) << name << ", ball " << i;
  }
}

TEST(EventCollapse, NeitherOrderNorWorkersChangeABit) {
  std::uint64_t collapsed = 0;
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}) {
    for (const double restitution : {0.2, 0.3}) {
      const Scene scene = dense_and_dissipative(seed, restitution);
      const End expected = run(scene, 1);
      collapsed += expected.resting > 0 ? 1 : 0;
      const std::string name = "seed " + std::to_string(seed);
      Scene reversed = scene;
      std::reverse(reversed.balls.begin(), reversed.balls.end());
      End turned = run(reversed, 1);
      std::reverse(turned.balls.begin(), turned.balls.end());
      expect_same(turned, expected, name + ", reversed");
      expect_same(run(scene, 3), expected, name + ", 3 workers");
    }
  }
  EXPECT_GE(collapsed, 8U);
}

}  // namespace
}  // namespace carom::event_collapse_test
