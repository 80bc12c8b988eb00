// How errors fall with the step, in scenes whose end is known in closed form.
//
// A step sees a contact at its end, late by a part of itself that is as good as drawn by lot, so
// that one scene's errors jump by up to twofold from rung to rung; over many starts their root mean
// square falls smoothly.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <ostream>
#include <random>

#include "accuracy/samples.hpp"
#include "carom/simulation.hpp"
#include "support/scenes.hpp"

namespace carom::order_test {
namespace {

constexpr int kStarts = 16;

/// A scene, and where its balls are at its duration.
struct Known {
  Scene scene;
  std::vector<Vec2> end;
};

/// Two equal disks meet off centre: along the line of centres they change velocities.
Known two_disks(std::mt19937_64& engine) {
  Known known;
  known.scene.effects.collisions = Collisions{};
  known.scene.duration = 4;
  const double offset = 0.3;
  const Vec2 first{3, 5};
  const Vec2 second{7 + test::uniform(engine), 5 + offset};
  known.scene.balls = {{first, {1, 0}}, {second, {-1, 0}}};
  const double along = std::sqrt(1 - offset * offset);  // of the distance at contact, which is 1
  const double touch = (second.x() - first.x() - along) / 2;
  const Vec2 normal{along, offset};
  const double rest = known.scene.duration - touch;
  const Vec2 exchanged = 2 * normal.x() * normal;
  known.end = {first + Vec2{touch, 0} + rest * (Vec2{1, 0} - exchanged),
               second - Vec2{touch, 0} + rest * (exchanged - Vec2{1, 0})};
  return known;
}

/// A ball falls on the floor and rises again.
Known bouncing_ball(std::mt19937_64& engine) {
  constexpr double kG = 9.81;
  Known known;
  known.scene.effects.walls = Walls{};
  known.scene.effects.gravity = Gravity{{0, -kG}};
  known.scene.duration = 1.5;
  const double height = 4 + test::uniform(engine);
  known.scene.balls = {{{3, height + 0.5}, {0.3, 0}}};
  const double touch = std::sqrt(2 * height / kG);
  const double rest = known.scene.duration - touch;
  known.end = {{3 + 0.3 * 1.5, 0.5 + kG * touch * rest - kG * rest * rest / 2}};
  return known;
}

/// Equal balls in a line between walls: less their own lengths they are points that pass through
/// each other.
/// Source: Jepsen, J. Math. Phys. 6 (1965) 405.
Known rods(std::mt19937_64& engine) {
  constexpr int kRods = 5;
  Known known;
  known.scene.effects.walls = Walls{};
  known.scene.effects.collisions = Collisions{};
  known.scene.duration = 6;
  const double room = known.scene.box.width - kRods;
  std::vector<double> points;
  for (int i = 0; i < kRods; ++i) {
    const double at = 3 * i + 1 + test::uniform(engine);
    const double velocity = test::gaussian(engine);
    known.scene.balls.push_back({{at + i + 0.5, 5}, {velocity, 0}});
    const double folded = std::remainder(at + velocity * known.scene.duration, 2 * room);
    points.push_back(std::abs(folded));
  }
  for (int i = 0; i + 1 < kRods; ++i) {
    EXPECT_LT(known.scene.balls[static_cast<std::size_t>(i)].position.x() + 1,
              known.scene.balls[static_cast<std::size_t>(i) + 1].position.x());
  }
  std::sort(points.begin(), points.end());
  for (int i = 0; i < kRods; ++i) {
    known.end.emplace_back(points[static_cast<std::size_t>(i)] + i + 0.5, 5);
  }
  return known;
}

double error_of(const Known& known, Method method, double step) {
  Scene scene = known.scene;
  scene.workers = 1;
  scene.solver.method = method;
  scene.solver.step = step;
  Simulation simulation(scene);
  simulation.advance_to(scene.duration);
  const std::vector<Ball> balls = simulation.state();
  double largest = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    largest = std::max(largest, (balls[i].position - known.end[i]).norm());
  }
  return largest;
}

/// The slope of the logarithms, least squares.
double slope(const std::vector<std::pair<double, double>>& points) {
  double x = 0;
  double y = 0;
  for (const auto& [step, error] : points) {
    x += std::log(step) / static_cast<double>(points.size());
    y += std::log(error) / static_cast<double>(points.size());
  }
  double xx = 0;
  double xy = 0;
  for (const auto& [step, error] : points) {
    xx += (std::log(step) - x) * (std::log(step) - x);
    xy += (std::log(step) - x) * (std::log(error) - y);
  }
  return xy / xx;
}

struct Case {
  const char* name;
  Known (*make)(std::mt19937_64&);
};

void PrintTo(const Case& each, std::ostream* out) {
  *out << each.name;
}

class Order : public testing::TestWithParam<Case> {};

TEST_P(Order, OverlapsErrorHalvesWithTheStep) {
  std::vector<std::pair<double, double>> points;
  double step = accuracy::kLongestStep;
  for (int rung = 0; rung < accuracy::kSteps; ++rung, step /= 2) {
    std::mt19937_64 engine(7);
    double square = 0;
    for (int start = 0; start < kStarts; ++start) {
      const double error = error_of(GetParam().make(engine), Method::overlap, step);
      square += error * error / kStarts;
    }
    points.emplace_back(step, std::sqrt(square));
  }
  const double order = slope(points);
  RecordProperty("order", std::to_string(order));
  EXPECT_GE(order, 0.9);
  EXPECT_LE(order, 1.1);
}

TEST_P(Order, EventsErrorIsRoundingWhateverTheStep) {
  std::mt19937_64 engine(7);
  for (int start = 0; start < kStarts; ++start) {
    const Known known = GetParam().make(engine);
    const double error = error_of(known, Method::event, accuracy::kLongestStep);
    EXPECT_LE(error, 200 * 0x1p-53 * known.scene.box.width);
    EXPECT_EQ(error_of(known, Method::event, accuracy::kLongestStep / 1024), error);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Order,
                         testing::Values(Case{"TwoDisks", two_disks},
                                         Case{"BouncingBall", bouncing_ball}, Case{"Rods", rods}),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace carom::order_test
