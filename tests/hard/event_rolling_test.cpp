// A ball that lies on a wall slides, rolls and turns round as closed forms say.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/simulation.hpp"
#include "support/event_contact.hpp"

namespace carom::event_rolling_test {
namespace {

// Closed forms of a uniform disk on a wall with friction, at the end of `time`.
struct Roll {
  double x;
  double v;
  double spin;
};

void expect_rolls(const Scene& scene, const Ball& start, double time, const Roll& expected) {
  const test::ContactOutcome end = test::run_contact(scene, {start}, time);
  // What sliding and drag take is what is missing.
  EXPECT_NEAR(end.energy + end.dissipated, end.energy_before, 1e-12 * (1 + std::abs(end.energy)));
  EXPECT_NEAR(end.balls[0].position.x(), start.position.x() + expected.x, 1e-9);
  EXPECT_NEAR(end.balls[0].velocity.x(), expected.v, 1e-9);
  EXPECT_NEAR(end.balls[0].spin, expected.spin, 1e-9);
  EXPECT_EQ(end.balls[0].position.y(), start.position.y());
}

Scene friction_body(const Vec2& gravity, double friction, int digits = 16) {
  Scene scene = test::contact_box(1000, 12, 0.5, gravity, digits);
  scene.effects.friction = Friction{friction, friction};
  return scene;
}

constexpr double kG = 9.81;
constexpr double kRadius = 0.5;

TEST(EventRolls, on_a_slope_as_steep_as_friction_holds_or_steeper) {
  for (const int digits : {16, 34}) {
    for (const double tan : {0.1, 0.9}) {
      for (const double friction : {tan / 3 * 0.99, tan / 3 * 1.01}) {
        const double normal = kG / std::sqrt(1 + tan * tan);
        const double along = tan * normal;
        const bool rolls = friction > tan / 3;
        const double a = rolls ? along * 2 / 3 : along - friction * normal;
        const double turn = rolls ? -a / kRadius : -2 * friction * normal / kRadius;
        expect_rolls(friction_body({along, -normal}, friction, digits), test::contact_ball(5, 0.5),
                     4, {a * 8, a * 4, turn * 4});
      }
    }
  }
}

TEST(EventRolls, uphill_and_back) {
  Ball up = test::contact_ball(20, 0.5, 3, 0);
  up.spin = -6;
  const double a = -0.981 * 2 / 3;
  expect_rolls(friction_body({-0.981, -kG}, 0.4), up, 8,
               {3 * 8 + a * 32, 3 + a * 8, -(3 + a * 8) * 2});
}

// Thrown flat it slides until v = 2/3 v0; spun it drives itself up to a third of r w.
TEST(EventRolls, from_sliding_and_from_spinning) {
  for (const double e : {0.5, 1.0}) {
    Scene scene = friction_body({0, -kG}, 0.4);
    scene.effects.walls = Walls{e};
    const double a = 0.4 * kG;
    const double slide = 3 / (3 * a);
    expect_rolls(scene, test::contact_ball(5, 0.5, 3, 0), 6,
                 {3 * slide - a * slide * slide / 2 + 2 * (6 - slide), 2, -4});
    Ball spun = test::contact_ball(5, 0.5);
    spun.spin = -20;
    const double drive = 20 * kRadius / (3 * a);
    const double v = a * drive;
    expect_rolls(scene, spun, 3, {v * drive / 2 + v * (3 - drive), v, -v / kRadius});
  }
}

// v = v0 exp(-2 k t / 3).
TEST(EventRolls, with_drag) {
  Scene scene = friction_body({0, -kG}, 0.4);
  scene.effects.drag = Drag{0.5};
  Ball rolling = test::contact_ball(5, 0.5, 3, 0);
  rolling.spin = -6;
  const double v = 3 * std::exp(-2 * 0.5 * 4 / 3);
  expect_rolls(scene, rolling, 4, {(3 - v) * 3, v, -2 * v});
}

// Spun, it drives itself into a corner, where floor and wall slow it down: with N on the floor and
// mu N on the wall, N + mu^2 N = m g, by 2 mu (1 + mu) N / (m r) in a second.
// Seen to fail, without end, where it only slides.
TEST(EventRolls, in_a_corner_until_it_turns_no_more) {
  for (const double e : {0.3, 1.0}) {
    const double friction = 0.3;
    Scene scene = friction_body({0, -kG}, friction);
    scene.effects.walls = Walls{e};
    Ball spun = test::contact_ball(999.5, 0.5);
    spun.spin = -20;
    const double normal = kG / (1 + friction * friction);
    const double slower = 2 * friction * (1 + friction) * normal / kRadius;
    const test::ContactOutcome half = test::run_contact(scene, {spun}, 1);
    EXPECT_NEAR(half.balls[0].spin, -20 + slower, 1e-9) << e;
    const test::ContactOutcome end = test::run_contact(scene, {spun}, 20 / slower + 0.1);
    EXPECT_EQ(end.balls[0].position, spun.position) << e;
    EXPECT_EQ(end.balls[0].velocity, (Vec2{0, 0})) << e;
    EXPECT_EQ(end.balls[0].spin, 0) << e;
    EXPECT_NEAR(end.energy + end.dissipated, end.energy_before, 1e-9) << e;
  }
}

// Two that touch roll as one.
// Both touch both walls and are pressed to one.  The lower one bounces, turns, rubs at that wall
// and changes there to slide the other way.  Broken, it is lifted by the rounding of its place in
// each bounce, and never comes down.
TEST(EventRolls, in_a_tube_that_they_fill) {
  Scene scene = test::contact_box(1, 3, 0.9, {-3, -kG});
  scene.effects.friction = Friction{0.5, 0.5};
  const test::ContactOutcome end = test::run_contact(
      scene, {test::contact_ball(0.5, 0.5), test::contact_ball(0.5, 1.5, 0, 1)}, 3);
  EXPECT_NEAR(end.energy + end.dissipated, end.energy_before, 1e-12 * std::abs(end.energy_before));
  for (const Ball& ball : end.balls) {
    EXPECT_EQ(ball.velocity, Vec2(0, 0));
    EXPECT_EQ(ball.spin, 0);
    EXPECT_EQ(ball.position.x(), 0.5);
  }
  EXPECT_NEAR(end.balls[0].position.y(), 0.5, 1e-7);
  EXPECT_NEAR(end.balls[1].position.y(), 1.5, 1e-7);
}

TEST(EventRolls, two_that_touch) {
  const test::ContactOutcome end =
      test::run_contact(friction_body({0.981, -kG}, 0.4),
                        {test::contact_ball(5, 0.5), test::contact_ball(6, 0.5)}, 4);
  EXPECT_NEAR(end.balls[0].position.x(), 5 + 5.232, 1e-9);
  EXPECT_NEAR(end.balls[1].position.x(), 6 + 5.232, 1e-9);
  EXPECT_NEAR(end.balls[1].spin, -5.232, 1e-9);
}

// Three on a wall, pulled along it by a ten millionth, fall by the same.
TEST(EventContact, balls_on_a_wall_fall_along_it) {
  const test::ContactOutcome end = test::run_contact(
      test::contact_box(11, 12, 0.5, {-kG, -1e-6}),
      {test::contact_ball(0.5, 5.5), test::contact_ball(0.5, 6.5), test::contact_ball(0.5, 7.5)},
      100);
  EXPECT_NEAR(end.balls[0].position.y(), 5.5 - 1e-6 * 5000, 1e-9);
  EXPECT_NEAR(end.balls[2].position.y(), 7.5 - 1e-6 * 5000, 1e-9);
}

// One ball that lies, in every number of digits and however elastic.
TEST(EventContact, what_lies_from_the_start_lies_for_ever) {
  for (const int digits : {16, 34, 50, 100}) {
    for (const double e : {0.0, 0.5, 1.0}) {
      const Scene floor = test::contact_box(10, 12, e, {0, -9.81}, digits);
      for (const std::vector<Ball>& balls :
           {std::vector<Ball>{test::contact_ball(5, 0.5)},
            {test::contact_ball(5, 0.5), test::contact_ball(5, 1.5)},
            {test::fixed_ball(5, 3), test::contact_ball(5, 4)}}) {
        const test::ContactOutcome end = test::run_contact(floor, balls, 10);
        for (std::size_t k = 0; k < balls.size(); ++k) {
          EXPECT_NEAR(end.balls[k].position.x(), balls[k].position.x(), 1e-12)
              << digits << ' ' << e;
          EXPECT_NEAR(end.balls[k].position.y(), balls[k].position.y(), 1e-6) << digits << ' ' << e;
          EXPECT_EQ(end.balls[k].velocity, (Vec2{0, 0})) << digits << ' ' << e;
        }
      }
    }
  }
}

// Dropped from h on a floor of restitution e: at rest at sqrt(2 h / g) (1 + e) / (1 - e), with any
// number of digits.
TEST(EventContact, a_ball_comes_to_rest_in_all_digits) {
  for (const int digits : {34, 50, 100}) {
    const Scene floor = test::contact_box(10, 12, 0.5, {0, -9.81}, digits);
    const double rest = 3 * std::sqrt(2 / 9.81);
    EXPECT_GT(test::run_contact(floor, {test::contact_ball(5, 1.5)}, rest - 1e-6)
                  .balls[0]
                  .velocity.norm(),
              1e-7)
        << digits;
    EXPECT_EQ(test::run_contact(floor, {test::contact_ball(5, 1.5)}, rest + 1e-6).balls[0].velocity,
              (Vec2{0, 0}))
        << digits;
  }
}

// Thrown flat without spin it slides for v0 / (3 mu g), and loses a third of its energy: a line of
// the record, with the impulses m g t along the normal and m v0 / 3 along the wall. A slide that is
// not over yet is told at the end of the run.
TEST(EventRolls, what_sliding_takes_is_recorded) {
  constexpr double kFriction = 0.25;
  constexpr double kSpeed = 3;
  for (const double part : {2.0, 0.5}) {
    const double slides = kSpeed / (3 * kFriction * kG);
    const double time = part * slides;
    const double slid = std::min(time, slides);
    EventSolver solver(friction_body({0, -kG}, kFriction), {test::contact_ball(5, 0.5, kSpeed, 0)});
    solver.record_impacts(true);
    test::advance(solver, time);
    std::vector<Impact> impacts;
    solver.take_impacts(impacts, true);
    solver.tell_slides(0, impacts);
    ASSERT_EQ(impacts.size(), 1U);
    const Impact& line = impacts.front();
    EXPECT_EQ(line.kind, ImpactKind::rest);
    EXPECT_EQ(line.wall, Side::bottom);
    EXPECT_NEAR(line.time, slid, 1e-12);
    EXPECT_NEAR(line.impulse, kG * slid, 1e-12);
    EXPECT_NEAR(line.tangential, kFriction * kG * slid, 1e-12);
    const double slip = kSpeed - 3 * kFriction * kG * slid;
    EXPECT_NEAR(line.energy_lost, (kSpeed * kSpeed - slip * slip) / 6, 1e-12);
    EXPECT_NEAR(line.energy_lost, solver.dissipated(), 1e-12);
  }
}

// A script that changes friction changes it from then on: what slid goes on from where it is.
TEST(EventRolls, friction_that_is_set_acts_from_then_on) {
  EventSolver solver(friction_body({0, -kG}, 0.25), {test::contact_ball(5, 0.5, 3, 0)});
  test::advance(solver, 0.1);
  Effects ice;
  ice.friction = Friction{0, 0};
  solver.set(ice);
  test::advance(solver, 1.1);
  const double v = 3 - 0.25 * kG * 0.1;
  EXPECT_NEAR(solver.state()[0].velocity.x(), v, 1e-12);
  EXPECT_NEAR(solver.state()[0].position.x(), 5 + (3 + v) / 2 * 0.1 + v, 1e-12);
}

// Losses under gravity in any number of digits: what falls from h above its place loses m g h, and
// a stack of three stands with its centres a diameter apart.
// Seen to fail: with refusal of such scenes.
TEST(EventRest, what_loses_energy_comes_to_rest_in_all_digits) {
  for (const int digits : {34, 50, 100}) {
    Scene scene = test::contact_box(10, 12, 0.5, {0, -kG}, digits);
    scene.solver.method = Method::event;
    scene.balls = {test::contact_ball(2, 2.5), test::contact_ball(5, 0.5),
                   test::contact_ball(5, 1.75), test::contact_ball(5, 3)};
    ASSERT_NO_THROW(Simulation{scene}) << digits;
    const test::ContactOutcome end = test::run_contact(scene, scene.balls, 6);
    EXPECT_NEAR(end.dissipated, kG * (2 + 0.25 + 0.5), 1e-3) << digits;
    EXPECT_EQ(end.balls[0].position.y(), 0.5) << digits;
    for (const std::size_t k : {0U, 1U, 2U}) {
      EXPECT_NEAR(end.balls[k + 1].position.y(), 0.5 + static_cast<double>(k), 1e-5) << digits;
    }
    for (const Ball& ball : end.balls) EXPECT_EQ(ball.velocity, Vec2(0, 0)) << digits;
  }
}

// On a large fixed ball it rolls as if its own steps were as short as its radius asks: with L the
// sum of the radii, v^2 = 4/3 g L (cos a - cos b) from angle a to b, .1 to .127452 in 2 s (by
// Runge and Kutta's method).
// Seen to fail: by 6e-5, and 8e-4 r above it, where the large one makes steps long.
TEST(EventRolls, on_a_large_fixed_ball) {
  constexpr double kReach = 50.1;
  Scene scene = friction_body({0, -kG}, 0.5);
  scene.box.width = 200;
  scene.box.height = 160;
  const Ball ball =
      test::contact_ball(100 + kReach * std::sin(0.1), 80 + kReach * std::cos(0.1), 0, 0, 0.1);
  const test::ContactOutcome end =
      test::run_contact(scene, {test::fixed_ball(100, 80, 50), ball}, 2);
  const Vec2 r{end.balls[1].position.x() - 100, end.balls[1].position.y() - 80};
  EXPECT_NEAR(kReach * std::atan2(r.x(), r.y()), 6.37331288, 1e-8);
  EXPECT_NEAR(r.norm(), kReach, 1e-9);
}

/// The angle to the plumb line of what starts at rest at `angle` and turns round a fixed ball,
/// after `time`: its second derivative is `pull` times its sine.  By the classical Runge-Kutta
/// method.
double fallen_to(double angle, double pull, double time) {
  constexpr int kSteps = 2000;
  const double h = time / kSteps;
  double rate = 0;
  for (int k = 0; k < kSteps; ++k) {
    const double a1 = pull * std::sin(angle);
    const double a2 = pull * std::sin(angle + h / 2 * rate);
    const double a3 = pull * std::sin(angle + h / 2 * (rate + h / 2 * a1));
    const double a4 = pull * std::sin(angle + h * (rate + h / 2 * a2));
    angle += h * rate + h * h / 6 * (a1 + a2 + a3);
    rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return angle;
}

// A uniform disk that rolls has two thirds of the pull of one that slides without friction.
TEST(EventRolls, on_a_fixed_ball_of_its_size) {
  constexpr double kStart = 0.1;
  for (const double friction : {0.0, 0.8}) {
    for (const double time : {0.3, 0.6}) {
      const Scene scene = friction_body({0, -kG}, friction);
      const Ball ball = test::contact_ball(10 + std::sin(kStart), 5 + std::cos(kStart));
      const test::ContactOutcome end =
          test::run_contact(scene, {test::fixed_ball(10, 5), ball}, time);
      const Vec2 r = end.balls[1].position - Vec2{10, 5};
      const double angle = fallen_to(kStart, friction > 0 ? kG * 2 / 3 : kG, time);
      EXPECT_GT(angle, 1.3 * kStart);
      EXPECT_NEAR(std::atan2(r.x(), r.y()), angle, 4e-9) << friction << ' ' << time;
      EXPECT_NEAR(r.norm(), 1, 4e-9);
      EXPECT_NEAR(end.energy + end.dissipated, end.energy_before, 1e-9);
    }
  }
}

}  // namespace
}  // namespace carom::event_rolling_test
