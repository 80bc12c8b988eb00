#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "carom/simulation.hpp"
#include "support/scenes.hpp"

namespace carom::overlap_test {
namespace {

// A scene drawn at random: loose or dense, with any of the effects, some balls fixed.
Scene any_scene() {
  const auto columns = *rc::gen::inRange<std::size_t>(1, 9);
  const auto rows = *rc::gen::inRange<std::size_t>(1, 9);
  const double packing = *rc::gen::element(0.05, 0.3, 0.6, 0.8);
  Scene scene = test::walled_gas(columns, rows, packing, *rc::gen::arbitrary<std::uint32_t>());
  scene.solver.step = 1.0 / *rc::gen::element(30, 60, 240, 1000);
  scene.effects.walls->restitution = *rc::gen::element(0.0, 0.2, 0.9, 1.0);
  scene.effects.collisions->restitution = *rc::gen::element(0.0, 0.2, 0.9, 1.0);
  if (*rc::gen::arbitrary<bool>()) scene.effects.gravity = Gravity{{0.25, -9.75}};
  const double speed = *rc::gen::element(0.0, 1.0, 30.0, 1e4);
  for (Ball& ball : scene.balls) {
    ball.velocity *= speed;
    ball.radius *= *rc::gen::element(1.0, 0.5, 0.125);
    ball.mass = *rc::gen::element(1.0, 0.5, 100.0);
    ball.fixed = *rc::gen::inRange(0, 8) == 0;
    if (ball.fixed) ball.velocity = {0, 0};
  }
  return scene;
}

bool has_fixed(const Scene& scene) {
  return std::any_of(scene.balls.begin(), scene.balls.end(),
                     [](const Ball& ball) { return ball.fixed; });
}

RC_GTEST_PROP(Overlap, EnergyNeverGrows, ()) {
  Scene scene = any_scene();
  if (*rc::gen::arbitrary<bool>()) scene.effects.friction = Friction{0.5, 0.25};
  Simulation simulation(scene);
  double energy = simulation.measure().energy_initial;
  // Rounding is relative to the energy there is to exchange.
  double scale = 0;
  for (const Ball& ball : scene.balls) {
    scale +=
        ball.mass * (ball.velocity.squaredNorm() / 2 + 10 * (scene.box.height + scene.box.width));
  }
  if (!scene.effects.gravity) scale = energy;
  for (int part = 1; part <= 5; ++part) {
    simulation.advance_to(part * 0.2);
    const double now = simulation.measure().energy_final;
    RC_ASSERT(now <= energy + 1e-12 * scale);
    energy = now;
  }
}

RC_GTEST_PROP(Overlap, NoBallIsEverOutsideItsWalls, ()) {
  const Scene scene = any_scene();
  Simulation simulation(scene);
  for (int frame = 1; frame <= 20; ++frame) {
    simulation.advance_to(frame / 30.0);
    for (const Ball& ball : simulation.state()) {
      if (ball.fixed) continue;
      RC_ASSERT(ball.position.x() >= ball.radius);
      RC_ASSERT(ball.position.y() >= ball.radius);
      RC_ASSERT(ball.position.x() <= scene.box.width - ball.radius);
      RC_ASSERT(ball.position.y() <= scene.box.height - ball.radius);
    }
  }
}

RC_GTEST_PROP(Overlap, MomentumIsKeptWithoutWallsAndFixedBalls, ()) {
  Scene scene = any_scene();
  scene.effects.walls.reset();
  scene.effects.gravity.reset();
  if (*rc::gen::arbitrary<bool>()) scene.box.periodic = {true, true};
  double scale = 0;
  for (Ball& ball : scene.balls) {
    ball.fixed = false;
    scale += ball.mass * ball.velocity.norm();
  }
  Simulation simulation(scene);
  simulation.advance_to(1);
  const Measurements after = simulation.measure();
  RC_ASSERT((after.momentum_final - after.momentum_initial).norm() <= 1e-12 * scale);
}

RC_GTEST_PROP(Overlap, FixedBallsStayWhereTheyAre, ()) {
  const Scene scene = any_scene();
  RC_PRE(has_fixed(scene));
  Simulation simulation(scene);
  simulation.advance_to(0.5);
  const std::vector<Ball> balls = simulation.state();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (!scene.balls[i].fixed) continue;
    RC_ASSERT(balls[i].position == scene.balls[i].position);
    RC_ASSERT(balls[i].velocity == Vec2(0, 0));
  }
}

RC_GTEST_PROP(Overlap, LengthsTimesAndMassesScaledByPowersOfTwoGiveTheSameRun, ()) {
  Scene scene = any_scene();
  // Speeds that fall by a large factor in each of many impacts end where numbers have no more
  // digits.
  for (double* e : {&scene.effects.walls->restitution, &scene.effects.collisions->restitution}) {
    *e = std::max(*e, 0.75);
  }
  const double length = std::ldexp(1, *rc::gen::inRange(-40, 40));
  const double time = std::ldexp(1, *rc::gen::inRange(-40, 40));
  const double mass = std::ldexp(1, *rc::gen::inRange(-40, 40));
  Scene scaled = scene;
  scaled.box.width *= length;
  scaled.box.height *= length;
  scaled.solver.step *= time;
  if (scaled.effects.gravity) scaled.effects.gravity->acceleration *= length / (time * time);
  for (Ball& ball : scaled.balls) {
    ball.position *= length;
    ball.velocity *= length / time;
    ball.radius *= length;
    ball.mass *= mass;
  }
  Simulation one(scene);
  Simulation other(scaled);
  one.advance_to(0.125);
  other.advance_to(0.125 * time);
  const std::vector<Ball> expected = one.state();
  const std::vector<Ball> balls = other.state();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    RC_ASSERT(balls[i].position == Vec2(expected[i].position * length));
    RC_ASSERT(balls[i].velocity == Vec2(expected[i].velocity * (length / time)));
  }
  RC_ASSERT(one.measure().ball_ball == other.measure().ball_ball);
  RC_ASSERT(one.measure().ball_wall == other.measure().ball_wall);
}

RC_GTEST_PROP(Overlap, AMirroredSceneGivesTheMirroredRun, ()) {
  // Only balls that coincide, as very fast ones do in a corner, have to be told apart by something
  // that a mirror does not turn.
  Scene scene = any_scene();
  for (Ball& ball : scene.balls) {
    if (ball.velocity.norm() > 8) ball.velocity /= 4096;
  }
  scene.box.origin = Box::Origin::center;
  for (Ball& ball : scene.balls) ball.position -= scene.box.size() / 2;
  Scene mirrored = scene;
  if (mirrored.effects.gravity) mirrored.effects.gravity->acceleration.x() *= -1;
  for (Ball& ball : mirrored.balls) {
    ball.position.x() *= -1;
    ball.velocity.x() *= -1;
  }
  Simulation one(scene);
  Simulation other(mirrored);
  one.advance_to(0.5);
  other.advance_to(0.5);
  const std::vector<Ball> expected = one.state();
  const std::vector<Ball> balls = other.state();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    RC_ASSERT(balls[i].position == Vec2(-expected[i].position.x(), expected[i].position.y()));
    RC_ASSERT(balls[i].velocity == Vec2(-expected[i].velocity.x(), expected[i].velocity.y()));
  }
}

}  // namespace
}  // namespace carom::overlap_test
