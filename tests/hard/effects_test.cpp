// The scenes of the single effects against theory, by each method that takes them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "carom/simulation.hpp"
#include "support/known_scene.hpp"

namespace carom::effects_test {
namespace {

using test::after;
using test::scene_of;
using test::total_momentum;

TEST(Walls, SendABallRoundTheDiamond) {
  // 3.5 in x and y to each middle of a side, at 2 m/s: back at the start after 7 s.
  const Scene scene = scene_of("walls");
  const auto event = after(scene_of("walls", Method::event), 7);
  EXPECT_NEAR((event[0].position - scene.balls[0].position).norm(), 0, 1e-12);
  // Each of the four hits may cost a step of the way.
  const auto overlap = after(scene, 7);
  const double step_length = scene.solver.step * scene.balls[0].velocity.norm();
  EXPECT_LT((overlap[0].position - scene.balls[0].position).norm(), 4 * step_length);
  EXPECT_NEAR(overlap[0].velocity.norm(), scene.balls[0].velocity.norm(), 1e-14);
}

TEST(Collisions, ShareMomentumAndLoseEnergyAsTheRestitutionSays) {
  const Scene scene = scene_of("collisions");
  const auto balls = after(scene, 6);
  // v_1' = v (m_1 - e m_2) / (m_1 + m_2), v_2' = v m_1 (1 + e) / (m_1 + m_2).
  EXPECT_NEAR(balls[0].velocity.x(), 4 * (1 - 0.5 * 3) / 4, 1e-14);
  EXPECT_NEAR(balls[1].velocity.x(), 4 * 1.5 / 4, 1e-14);
}

TEST(Gravity, ThrowsBallsOnParabolas) {
  for (const Method method : {Method::overlap, Method::event}) {
    const Scene scene = scene_of("gravity", method);
    const double t = 1.5;
    const auto balls = after(scene, t);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const Ball& start = scene.balls[i];
      EXPECT_NEAR(balls[i].position.x(), start.position.x() + start.velocity.x() * t, 1e-12);
      EXPECT_NEAR(balls[i].position.y(),
                  start.position.y() + start.velocity.y() * t - 9.81 * t * t / 2, 1e-12);
      EXPECT_NEAR(balls[i].velocity.y(), start.velocity.y() - 9.81 * t, 1e-12);
    }
  }
}

TEST(Gravity, BringsBallsBackToTheHeightsOfTheirBounces) {
  // Dropped from h with restitution e, the n-th bounce rises to e^(2n) h: by its speed at the
  // floor.
  Scene scene = scene_of("drop");
  scene.effects.walls->restitution = 0.8;
  scene.balls.resize(1);
  const double height = scene.balls[0].position.y() - 0.5;
  Simulation simulation(scene);
  std::uint64_t bounces = 0;
  for (int k = 1; bounces < 4; ++k) {
    ASSERT_LT(k, 2400);
    simulation.advance_to(k * scene.solver.step);
    if (simulation.measure().ball_wall == bounces) continue;
    ++bounces;
    const double speed = simulation.state()[0].velocity.y();
    EXPECT_NEAR(speed * speed / (2 * 9.81),
                std::pow(0.8, 2.0 * static_cast<double>(bounces)) * height, 1e-12);
  }
}

TEST(Drag, StopsABallAfterItsSpeedDividedByTheRate) {
  const Scene scene = scene_of("drag");
  for (const double t : {1.0, 5.0, 100.0}) {
    const auto balls = after(scene, t);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const double speed = scene.balls[i].velocity.x();
      const double way = speed / 0.5 * -std::expm1(-0.5 * t);
      EXPECT_NEAR(balls[i].position.x() - 1, way, 1e-11);
      EXPECT_NEAR(balls[i].velocity.x(), speed * std::exp(-0.5 * t), 1e-12);
    }
  }
  EXPECT_NEAR(after(scene, 100)[3].position.x(), 1 + 8 / 0.5, 1e-10);
}

TEST(Drag, UnderGravityLeadsToTheLimitOfSpeed) {
  Scene scene = scene_of("drag");
  scene.effects.gravity = Gravity{{0, -9.81}};
  const double t = 3;
  const auto balls = after(scene, t);
  const double limit = -9.81 / 0.5;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_NEAR(balls[i].velocity.y(), limit * -std::expm1(-0.5 * t), 1e-12);
    EXPECT_NEAR(balls[i].position.y() - scene.balls[i].position.y(),
                limit * (t + std::expm1(-0.5 * t) / 0.5), 1e-11);
  }
}

TEST(Drag, LosesOnTheWayToAWallWhatItLosesOnAnyWay) {
  // Without other forces dv/dx = -rate: the speed at the wall is v - rate d, at any step.
  for (const double step : {1.0 / 240, 1.0 / 7}) {
    Scene scene = scene_of("drag");
    scene.box.width = 5;
    scene.effects.walls = Walls{1};
    scene.solver.step = step;
    scene.balls = {Ball{{1, 2}, {8, 0}}};
    Simulation simulation(scene);
    double time = 0;
    while (simulation.measure().ball_wall == 0) simulation.advance_to(time += step);
    EXPECT_NEAR(simulation.state()[0].velocity.x(), -(8 - 0.5 * 3.5), 1e-12);
  }
}

TEST(Friction, EndsWithBallsThatRollAtTwoThirdsOfTheirSpeed) {
  // Whatever the impulses, m v + I w / r about the floor stays: v' = v 2/3 once r w = -v'.
  const Scene scene = scene_of("friction");
  const auto balls = after(scene, 8);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double speed = scene.balls[i].velocity.x() * 2 / 3;
    EXPECT_NEAR(balls[i].velocity.x(), speed, 1e-12);
    EXPECT_NEAR(balls[i].spin * balls[i].radius, -speed, 1e-12);
  }
}

TEST(Friction, IsTheCoulombImpulseAtEachBounce) {
  // Dropped from h with restitution e: J_n / m = (1 + e) sqrt(2 g h), then e times as much, ...
  const double mu = 0.05;
  const double e = 0.7;
  Scene scene = scene_of("friction");
  scene.effects.friction->walls = mu;
  scene.balls.resize(1);
  Simulation simulation(scene);
  double speed = 3;
  double spin = 0;
  double arrival = std::sqrt(2 * 9.81 * 3.5);
  std::uint64_t bounces = 0;
  for (int k = 1; bounces < 5; ++k) {
    ASSERT_LT(k, 2400);
    simulation.advance_to(k * scene.solver.step);
    if (simulation.measure().ball_wall == bounces) continue;
    ++bounces;
    const double slip = speed + 0.5 * spin;
    const double impulse = std::min(slip / 3, mu * (1 + e) * arrival);
    speed -= impulse;
    spin -= 2 * impulse / 0.5;
    arrival *= e;
    EXPECT_NEAR(simulation.state()[0].velocity.x(), speed, 1e-12);
    EXPECT_NEAR(simulation.state()[0].spin, spin, 1e-12);
  }
}

TEST(Friction, TurnsTwoBallsThatGlanceEachOther) {
  // An impact with sticking contact: u = (v_2 - v_1).t - r (w_1 + w_2), J_t = -u / (3/m_1 + 3/m_2).
  Scene scene = scene_of("friction");
  scene.effects = Effects{};
  scene.effects.collisions = Collisions{1};
  scene.effects.friction = Friction{10, 0};
  scene.balls = {Ball{{4, 5}, {1, 0.3}}, Ball{{5.5, 5}, {0, 0}}};
  scene.balls[1].mass = 2;
  scene.balls[1].spin = 0.5;
  const double slip = (0 - 0.3) - 0.5 * 0.5;
  const double impulse = -slip / (3 + 1.5);
  for (const double step : {1.0 / 1024, 1.0 / 65536}) {
    scene.solver.step = step;
    Simulation simulation(scene);
    simulation.advance_to(1);
    ASSERT_EQ(simulation.measure().ball_ball, 1U);
    const auto balls = simulation.state();
    // The line of centres has turned by then: to the first order in the slope of 0.15.
    const double tilt = (balls[0].velocity - Vec2(-1.0 / 3, 0.3 - impulse)).norm();
    EXPECT_LT(tilt, 0.4);
    EXPECT_NEAR(total_momentum(balls).x(), 1, 1e-14);
    EXPECT_NEAR(total_momentum(balls).y(), 0.3, 1e-14);
    // Each got the same turn: dw = -2 J / (m r).
    EXPECT_NEAR(balls[0].spin, 2 * (balls[1].spin - 0.5), 1e-14);
    EXPECT_NEAR(balls[0].spin, -2 * impulse / 0.5, 0.2);
    // Sticking: no slip is left, along the tangent of the line of centres at the impact.
    const Measurements measured = simulation.measure();
    EXPECT_LT(measured.energy_final, measured.energy_initial);
  }
}

}  // namespace
}  // namespace carom::effects_test
