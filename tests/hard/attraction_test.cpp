// Attraction against theory, by both methods that take it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "carom/report.hpp"
#include "carom/simulation.hpp"
#include "support/known_scene.hpp"

namespace carom::attraction_test {
namespace {

using test::after;
using test::scene_of;
using test::total_momentum;

class Orbit : public testing::TestWithParam<Method> {};

TEST_P(Orbit, HasTheKeplerPeriodAndEccentricity) {
  Scene scene = scene_of("attraction", GetParam());
  scene.solver.step = 2 * std::numbers::pi / 2048;
  Simulation simulation(scene);
  double nearest = 10;
  double farthest = 0;
  double crossing = 0;
  double before = -1;
  for (int k = 1; k <= 2048; ++k) {
    const double t = k * scene.solver.step;
    simulation.advance_to(t);
    const auto balls = simulation.state();
    const Vec2 r = balls[1].position - balls[0].position;
    nearest = std::min(nearest, r.norm());
    farthest = std::max(farthest, r.norm());
    // Through the axis upwards at the apoapsis: one period after the start.
    if (k > 1024 && before < 0 && r.y() >= 0) {
      crossing = t - scene.solver.step * r.y() / (r.y() - before);
    }
    before = r.y();
    ASSERT_LE(total_momentum(balls).norm(), 1e-12);
  }
  const double eccentricity = (farthest - nearest) / (farthest + nearest);
  EXPECT_NEAR(eccentricity, 0.5, 1e-4);
  if (crossing == 0) crossing = 2 * std::numbers::pi - before / 0.57735026918962576;
  EXPECT_NEAR(crossing, 2 * std::numbers::pi, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Methods, Orbit, testing::Values(Method::overlap, Method::event),
                         [](const auto& each) { return method_name(each.param); });

TEST(Attraction, ClosesAnEllipseToAMillionthAfterAThousandTurns) {
  Scene scene = scene_of("attraction", Method::event);
  scene.solver.step = 2 * std::numbers::pi / 200;
  Simulation simulation(scene);
  simulation.advance_to(2000 * std::numbers::pi);
  const auto balls = simulation.state();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR((balls[i].position - scene.balls[i].position).norm(), 0, 1e-6);
  }
  EXPECT_LE(total_momentum(balls).norm(), 1e-12);
}

TEST(Attraction, KeepsTheMomentumOfManyBodies) {
  for (const Method method : {Method::overlap, Method::event}) {
    Scene scene = scene_of("everything", method);
    scene.effects.walls.reset();
    scene.effects.gravity.reset();
    scene.effects.drag.reset();
    Simulation simulation(scene);
    const Vec2 momentum = simulation.measure().momentum_initial;
    simulation.advance_to(3);
    EXPECT_GT(simulation.measure().ball_ball, 5U);
    EXPECT_LE((simulation.measure().momentum_final - momentum).norm(), 1e-12);
  }
}

// The slope of the error over the step, by least squares of the logarithms.
double order(const std::vector<double>& steps, const std::vector<double>& errors) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto n = static_cast<double>(steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double x = std::log(steps[k]);
    const double y = std::log(errors[k]);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double largest_distance(const std::vector<Ball>& balls, const std::vector<Ball>& others) {
  double largest = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    largest = std::max(largest, (balls[i].position - others[i].position).norm());
  }
  return largest;
}

Scene three_bodies() {
  Scene scene = scene_of("attraction", Method::event);
  scene.box.width = 8;
  scene.box.height = 6;
  scene.effects.attraction = Attraction{2, 0.1};
  scene.balls = {Ball{{-2, 0.3}, {1, 0.2}, 0.3}, Ball{{2, 0.2}, {-1, 0.1}, 0.4, 2},
                 Ball{{0.1, 2}, {0.3, -1}, 0.3}};
  return scene;
}

double measured_order(Scene scene, const std::vector<double>& steps, double time) {
  scene.solver.step = steps.back() / 8;
  const auto truth = after(scene, time);
  std::vector<double> errors;
  for (const double step : steps) {
    scene.solver.step = step;
    errors.push_back(largest_distance(after(scene, time), truth));
  }
  return order(steps, errors);
}

TEST(Attraction, IsIntegratedToTheFourthOrder) {
  const std::vector<double> steps{1.0 / 16, 1.0 / 24, 1.0 / 32, 1.0 / 48};
  Scene scene = three_bodies();
  scene.balls[1].position = {2, 1.5};
  EXPECT_NEAR(measured_order(scene, steps, 0.9), 4, 0.3);
  scene.effects.gravity = Gravity{{0.1, -1}};
  scene.effects.drag = Drag{0.3};
  EXPECT_NEAR(measured_order(scene, steps, 0.9), 4, 0.3);
}

TEST(Attraction, KeepsItsOrderThroughImpacts) {
  const std::vector<double> steps{1.0 / 16, 1.0 / 24, 1.0 / 32, 1.0 / 48, 1.0 / 64};
  Scene scene = three_bodies();
  scene.effects.walls = Walls{0.9};
  scene.effects.collisions = Collisions{0.9};
  scene.effects.friction = Friction{0.2, 0.3};
  const double found = measured_order(scene, steps, 2);
  EXPECT_GT(found, 2);
  EXPECT_LT(found, 6);
}

TEST(Attraction, KeepsTheEnergyOfElasticBallsThatMeet) {
  Scene scene = scene_of("everything", Method::event);
  scene.effects = Effects{};
  scene.effects.walls = Walls{};
  scene.effects.collisions = Collisions{};
  scene.effects.attraction = Attraction{2, 0.1};
  scene.solver.step = 1.0 / 240;
  Simulation simulation(scene);
  simulation.advance_to(3);
  const Measurements measured = simulation.measure();
  EXPECT_GT(measured.ball_ball, 50U);
  EXPECT_NEAR(measured.relative_energy_error(), 0, 1e-9);
  EXPECT_LT(measured.max_overlap, 1e-9);
}

TEST(Attraction, LetsBallsThatStickLieOnEachOther) {
  for (const Method method : {Method::overlap, Method::event}) {
    Scene scene = scene_of("attraction", method);
    scene.effects.collisions = Collisions{0.3};
    scene.balls[0].velocity = scene.balls[1].velocity = {0, 0};
    Simulation simulation(scene);
    simulation.advance_to(4);
    const std::uint64_t impacts = simulation.measure().ball_ball;
    simulation.advance_to(8);
    EXPECT_EQ(simulation.measure().ball_ball, impacts);
    for (const Ball& ball : simulation.state()) {
      EXPECT_NEAR(std::abs(ball.position.x()), 0.1, 1e-9);
      EXPECT_NEAR(ball.velocity.norm(), 0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace carom::attraction_test
