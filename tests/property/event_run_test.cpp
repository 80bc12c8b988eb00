// Whole runs of method event: what a mirror, other units, other numbers of the balls, other
// workers, a stop on the way or time turned round must not change.  Scenes are drawn at random;
// a failure prints the seed, and RC_PARAMS="seed=..." draws the same ones again.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "carom/scene_file.hpp"
#include "carom/simulation.hpp"
#include "support/drawn_number.hpp"
#include "verify/runs.hpp"
#include "verify/transform.hpp"

namespace carom::event_run_test {
namespace {

using test::number;

constexpr double kTime = 3;

// Any combination of effects the method takes, some balls fixed, radii and masses mixed, in a box
// of any kind about its centre.
Scene any_scene() {
  const auto columns = *rc::gen::inRange(1, 6);
  const auto rows = *rc::gen::inRange(1, 6);
  Scene scene;
  scene.solver.method = Method::event;
  scene.workers = 1;
  scene.box.origin = Box::Origin::center;
  scene.box.width = 2 * columns + 1;
  scene.box.height = 2 * rows + 1;
  for (std::size_t axis : {0U, 1U}) {
    const double side = axis == 0 ? scene.box.width : scene.box.height;
    scene.box.periodic[axis] = side > 6 && *rc::gen::arbitrary<bool>();
  }
  scene.effects.collisions = Collisions{*rc::gen::element(1.0, 1.0, 0.9)};
  scene.effects.walls = Walls{*rc::gen::element(1.0, 1.0, 0.9)};
  const bool lossless =
      scene.effects.collisions->restitution == 1 && scene.effects.walls->restitution == 1;
  if (*rc::gen::arbitrary<bool>()) scene.effects.gravity = Gravity{{number(-1, 1), number(-9, 9)}};
  if ((lossless || !scene.effects.gravity) && *rc::gen::arbitrary<bool>()) {
    scene.effects.drag = Drag{number(0.01, 1)};
  }
  const bool has_friction = *rc::gen::arbitrary<bool>();
  if (has_friction) scene.effects.friction = Friction{number(0, 0.5), number(0, 0.5)};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      Ball ball;
      ball.position = {-scene.box.width / 2 + 0.5 + 2 * column + number(0.75, 1.25),
                       -scene.box.height / 2 + 0.5 + 2 * row + number(0.75, 1.25)};
      ball.radius = number(0.1, 0.7);
      ball.mass = number(0.1, 10);
      ball.fixed = *rc::gen::inRange(0, 10) == 0;
      if (!ball.fixed) {
        ball.velocity = {number(-4, 4), number(-4, 4)};
        if (has_friction) ball.spin = number(-4, 4);
      }
      scene.balls.push_back(ball);
    }
  }
  RC_PRE(find_problems(scene).empty());
  return scene;
}

RC_GTEST_PROP(EventRun, LengthsTimesAndMassesScaledByPowersOfTwoChangeNoBit, ()) {
  const Scene scene = any_scene();
  const double length = std::ldexp(1, *rc::gen::inRange(-60, 60));
  const double time = std::ldexp(1, *rc::gen::inRange(-60, 60));
  const double mass = std::ldexp(1, *rc::gen::inRange(-60, 60));
  const auto expected = hard::run(scene, kTime);
  const auto found = hard::run(hard::scaled(scene, length, time, mass), kTime * time);
  RC_ASSERT(hard::different(found.balls, hard::scaled(expected.balls, length, time, mass)) == 0);
  RC_ASSERT(found.measured.ball_ball == expected.measured.ball_ball);
  RC_ASSERT(found.measured.ball_wall == expected.measured.ball_wall);
}

RC_GTEST_PROP(EventRun, AMirrorTurnsTheRunAndNothingElse, ()) {
  const Scene scene = any_scene();
  const auto mirror = *rc::gen::element(hard::Mirror::x, hard::Mirror::y, hard::Mirror::diagonal);
  const auto expected = hard::run(scene, kTime);
  const auto found = hard::run(hard::mirrored(scene, mirror), kTime);
  RC_ASSERT(hard::different(found.balls, hard::mirrored(expected.balls, mirror)) == 0);
}

RC_GTEST_PROP(EventRun, TheNumbersOfTheBallsMeanNothing, ()) {
  const Scene scene = any_scene();
  const hard::Shuffle shuffle(scene.balls.size(), *rc::gen::arbitrary<std::uint32_t>());
  Scene other = scene;
  other.balls = shuffle.there(scene.balls);
  const auto expected = hard::run(scene, kTime);
  const auto found = hard::run(other, kTime);
  RC_ASSERT(hard::different(shuffle.back(found.balls), expected.balls) == 0);
}

RC_GTEST_PROP(EventRun, NeitherWorkersNorFramesNorAStopChangeABit, ()) {
  const Scene scene = any_scene();
  const auto expected = hard::run(scene, kTime);
  Scene other = scene;
  const auto workers = *rc::gen::inRange<std::size_t>(0, 8);
  other.per_ball = workers == 0;
  other.workers = workers;
  if (workers == 0) other.workers.reset();
  Simulation first(other);
  const double stop = number(0, kTime);
  const double frame = number(0.001, 1);
  for (double time = frame; time < stop; time += frame) first.advance_to(time);
  first.advance_to(stop);
  RC_ASSERT(hard::different(first.state(), hard::run(scene, stop).balls) == 0);
  const auto found = hard::run(parse_scene(write_scene(first.save()), "saved"), kTime);
  RC_ASSERT(hard::different(found.balls, expected.balls) == 0);
  RC_ASSERT(first.measure().ball_ball <= expected.measured.ball_ball);
}

// Without losses energy stays; momentum where neither walls nor fixed balls take it.
RC_GTEST_PROP(EventRun, EnergyStaysWhereNothingTakesIt, ()) {
  Scene scene = any_scene();
  scene.effects.collisions->restitution = scene.effects.walls->restitution = 1;
  scene.effects.drag.reset();
  scene.effects.friction.reset();
  for (Ball& ball : scene.balls) ball.spin = 0;
  const auto measured = hard::run(scene, kTime).measured;
  double scale = 0;  // what there is to exchange
  for (const Ball& ball : scene.balls) {
    double fall = 0;
    if (scene.effects.gravity) {
      // Round a periodic axis it goes on.
      const double g = scene.effects.gravity->acceleration.norm();
      const bool round = scene.box.periodic[0] || scene.box.periodic[1];
      const double way = round ? (6 + g * kTime) * kTime : 0;
      fall = g * (scene.box.width + scene.box.height + way);
    }
    scale += ball.mass * (ball.velocity.squaredNorm() / 2 + fall);
  }
  RC_ASSERT(std::abs(measured.energy_final - measured.energy_initial) <= 1e-13 * scale);
}

// Chaos makes a way back as wrong as its condition: more digits come back nearer by as much as
// they are more.
RC_GTEST_PROP(EventRun, TimeTurnedRoundComesBackTheNearerTheMoreDigits, ()) {
  Scene scene = any_scene();
  scene.effects.collisions->restitution = scene.effects.walls->restitution = 1;
  scene.effects.drag.reset();
  scene.effects.friction.reset();
  // Flights start again, to be turned round, where the field is set.
  if (!scene.effects.gravity) scene.effects.gravity = Gravity{{0, 0}};
  for (Ball& ball : scene.balls) ball.spin = 0;
  scene.duration = 1;
  const double size = scene.box.width + scene.box.height;
  scene.solver.digits = 50;
  RC_ASSERT(hard::way_back(scene) <= 0x1p-52 * size);
  scene.solver.digits = 16;
  const double less = hard::way_back(scene);
  scene.solver.digits = 34;
  RC_ASSERT(hard::way_back(scene) <= 1e-10 * less + 0x1p-52 * size);
}

}  // namespace
}  // namespace carom::event_run_test
