#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <ostream>
#include <random>
#include <vector>

#include "solvers/event/solver.hpp"
#include "support/advance.hpp"

namespace carom::event_symmetry_test {
namespace {

struct Case {
  const char* name;
  std::array<bool, 2> periodic;
  bool gravity;
  bool drag = false;
  bool friction = false;
};

void PrintTo(const Case& each, std::ostream* out) {
  *out << each.name;
}

Scene mixture(const Case& wanted) {
  Scene scene;
  scene.box.width = 16;
  scene.box.height = 12;
  scene.box.periodic = wanted.periodic;
  scene.box.origin = Box::Origin::center;
  scene.effects.walls = Walls{1};
  scene.effects.collisions = Collisions{0.95};
  if (wanted.gravity) scene.effects.gravity = Gravity{{0.25, -1.5}};
  if (wanted.drag) scene.effects.drag = Drag{0.07};
  if (wanted.friction) scene.effects.friction = Friction{0.2, 0.3};
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 10; ++column) {
      Ball ball;
      ball.position = {-8 + 1.6 * (column + 0.5), -6 + 1.5 * (row + 0.5)};
      ball.velocity = {normal(random), normal(random)};
      ball.radius = 0.3 + 0.02 * ((row * 7 + column) % 20);
      ball.mass = 0.5 + (row + 3 * column) % 5;
      if (wanted.friction) ball.spin = normal(random);
      ball.fixed = row == 4 && column % 4 == 1;
      scene.balls.push_back(ball);
    }
  }
  return scene;
}

struct End {
  std::vector<Ball> balls;
  Measurements measured;
};

End run(const Scene& scene, double time = 6, int frames = 1) {
  const auto solver = std::make_unique<EventSolver>(scene, scene.balls);
  for (int frame = 1; frame <= frames; ++frame) {
    test::advance(*solver, time * frame / frames);
  }
  End end;
  end.balls = solver->state();
  solver->count(end.measured);
  return end;
}

void expect_same(const End& expected, const End& got, const std::function<Vec2(Vec2)>& place,
                 const std::function<Vec2(Vec2)>& velocity, double spin) {
  ASSERT_GT(expected.measured.ball_ball, 300U);
  EXPECT_EQ(expected.measured.ball_ball, got.measured.ball_ball);
  EXPECT_EQ(expected.measured.ball_wall, got.measured.ball_wall);
  for (std::size_t i = 0; i < got.balls.size(); ++i) {
    ASSERT_EQ(place(expected.balls[i].position), got.balls[i].position) << i;
    ASSERT_EQ(velocity(expected.balls[i].velocity), got.balls[i].velocity) << i;
    ASSERT_EQ(expected.balls[i].spin * spin, got.balls[i].spin) << i;
  }
}

void transform(Scene& scene, const std::function<Vec2(Vec2)>& place,
               const std::function<Vec2(Vec2)>& velocity,
               const std::function<Vec2(Vec2)>& acceleration, double spin) {
  for (Ball& ball : scene.balls) {
    ball.position = place(ball.position);
    ball.velocity = velocity(ball.velocity);
    ball.spin *= spin;
  }
  if (scene.effects.gravity) {
    scene.effects.gravity->acceleration = acceleration(scene.effects.gravity->acceleration);
  }
}

class EventSymmetry : public testing::TestWithParam<Case> {
 protected:
  Scene scene_ = mixture(GetParam());
};

TEST_P(EventSymmetry, a_scene_mirrored_in_x_gives_the_mirrored_bits) {
  const auto mirror = [](Vec2 v) { return Vec2{-v.x(), v.y()}; };
  Scene other = scene_;
  transform(other, mirror, mirror, mirror, -1);
  expect_same(run(scene_), run(other), mirror, mirror, -1);
}

TEST_P(EventSymmetry, a_scene_mirrored_in_y_gives_the_mirrored_bits) {
  const auto mirror = [](Vec2 v) { return Vec2{v.x(), -v.y()}; };
  Scene other = scene_;
  transform(other, mirror, mirror, mirror, -1);
  expect_same(run(scene_), run(other), mirror, mirror, -1);
}

TEST_P(EventSymmetry, a_scene_with_x_and_y_swapped_gives_the_swapped_bits) {
  const auto swap = [](Vec2 v) { return Vec2{v.y(), v.x()}; };
  Scene other = scene_;
  std::swap(other.box.width, other.box.height);
  std::swap(other.box.periodic[0], other.box.periodic[1]);
  transform(other, swap, swap, swap, -1);
  expect_same(run(scene_), run(other), swap, swap, -1);
}

TEST_P(EventSymmetry, the_order_of_the_balls_changes_no_bit) {
  std::vector<std::size_t> order(scene_.balls.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937_64 random(9);
  std::shuffle(order.begin(), order.end(), random);
  Scene other = scene_;
  for (std::size_t k = 0; k < order.size(); ++k) other.balls[k] = scene_.balls[order[k]];
  const End expected = run(scene_);
  End got = run(other);
  std::vector<Ball> sorted(got.balls.size());
  for (std::size_t k = 0; k < order.size(); ++k) sorted[order[k]] = got.balls[k];
  got.balls = sorted;
  const auto same = [](Vec2 v) { return v; };
  expect_same(expected, got, same, same, 1);
}

TEST_P(EventSymmetry, lengths_times_and_masses_times_powers_of_two_give_the_same_run) {
  static constexpr double kLength = 0x1p-20;
  static constexpr double kTime = 0x1p7;
  static constexpr double kMass = 0x1p33;
  const auto place = [](const Vec2& v) { return Vec2(v * kLength); };
  const auto velocity = [](const Vec2& v) { return Vec2(v * (kLength / kTime)); };
  const auto acceleration = [](const Vec2& v) { return Vec2(v * (kLength / kTime / kTime)); };
  Scene other = scene_;
  other.box.width *= kLength;
  other.box.height *= kLength;
  transform(other, place, velocity, acceleration, 1 / kTime);
  if (other.effects.drag) other.effects.drag->rate /= kTime;
  for (Ball& ball : other.balls) {
    ball.radius *= kLength;
    ball.mass *= kMass;
  }
  expect_same(run(scene_), run(other, 6 * kTime), place, velocity, 1 / kTime);
}

TEST_P(EventSymmetry, frames_only_look) {
  const auto same = [](Vec2 v) { return v; };
  const End once = run(scene_);
  expect_same(once, run(scene_, 6, 7), same, same, 1);
  expect_same(once, run(scene_, 6, 2000), same, same, 1);
}

// Whatever is kept beside the flights is made again: neighbours, event queue, the order in memory.
TEST_P(EventSymmetry, setting_an_effect_to_what_it_is_changes_no_bit) {
  const auto solver = std::make_unique<EventSolver>(scene_, scene_.balls);
  const std::vector<Phase> phases = solver->phases();
  for (int part = 1; part <= 12; ++part) {
    ASSERT_NE(solver->aim(part * 0.5), Phase::kFrameDone);
    phases[0].work(Share{0, 1});
    Effects effects;
    effects.collisions = scene_.effects.collisions;
    solver->set(effects);
  }
  End end;
  end.balls = solver->state();
  solver->count(end.measured);
  const auto same = [](Vec2 v) { return v; };
  expect_same(run(scene_), end, same, same, 1);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, EventSymmetry,
    testing::Values(Case{"box", {false, false}, false}, Case{"channel", {true, false}, false},
                    Case{"torus", {true, true}, false}, Case{"falling", {false, false}, true},
                    Case{"rubbing", {true, false}, false, false, true},
                    Case{"falling_and_rubbing", {false, false}, true, false, true},
                    Case{"damped", {false, true}, false, true},
                    Case{"all", {false, false}, true, true, true}),
    [](const auto& scene) { return scene.param.name; });

}  // namespace
}  // namespace carom::event_symmetry_test
