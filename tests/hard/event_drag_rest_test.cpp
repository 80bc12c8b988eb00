// Contacts that come to rest under drag, and elastic balls that something else takes energy from.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "carom/scene_file.hpp"
#include "carom/simulation.hpp"
#include "hard/elastic_setting.hpp"

namespace carom::event_drag_rest_test {
namespace {

Ball fixed_disk(double x, double y) {
  Ball result = ball(x, y);
  result.fixed = true;
  return result;
}

Scene elastic(const Vec2& gravity, double drag) {
  Scene scene = elastic_box(10, gravity);
  scene.effects.drag = Drag{drag};
  return scene;
}

// The speed of a fall fades by drag, to exp(-50): without rest there are e^50 bounces.
TEST(EventDragRest, an_elastic_hop_that_drag_makes_ever_shorter_ends_on_the_floor) {
  Scene scene = elastic({0, -9.81}, 0.5);
  scene.balls = {ball(5, 5)};
  const Simulation run = at_time(scene, 100);
  EXPECT_EQ(run.state()[0].position, Vec2(5, 0.5));
  EXPECT_EQ(run.state()[0].velocity, Vec2(0, 0));
  EXPECT_EQ(run.measure().resting_contacts, 1U);
  EXPECT_NEAR(run.measure().energy_final, 9.81 * 0.5, 1e-12);
}

TEST(EventDragRest, an_elastic_ball_comes_to_rest_between_two_fixed_ones) {
  Scene scene = elastic({0, -9.81}, 1);
  scene.balls = {fixed_disk(4.3, 2), fixed_disk(5.7, 2), ball(5.02, 3.2)};
  const std::vector<Ball> balls = at_time(scene, 60).state();
  // It touches both: 0.7 to either side, 1 from either centre.
  EXPECT_NEAR(balls[2].position.x(), 5, 1e-4);
  EXPECT_NEAR(balls[2].position.y(), 2 + std::sqrt(1 - 0.49), 1e-4);
  EXPECT_EQ(balls[2].velocity, Vec2(0, 0));
}

TEST(EventDragRest, elastic_balls_pile_up_and_rest) {
  Scene scene = elastic({0, -9.81}, 1);
  scene.box.width = 2;  // two side by side fit to the last bit
  scene.balls = {ball(0.6, 1), ball(1.4, 2), ball(0.7, 3), ball(1.3, 4)};
  const Simulation run = at_time(scene, 60);
  for (const Ball& b : run.state()) EXPECT_EQ(b.velocity, Vec2(0, 0));
  EXPECT_GE(run.measure().resting_contacts, 4U);
}

// Wherever a run is looked at, or is stopped and gone on: before the balls rest, and after.
TEST(EventDragRest, nothing_depends_on_frames_stops_or_workers) {
  Scene scene = elastic({0.3, -9.81}, 0.7);
  scene.balls = {ball(3, 5, 2, 1), ball(3.2, 7),       ball(3, 9),
                 fixed_disk(7, 1), fixed_disk(8.3, 1), ball(7.6, 5)};
  const std::string whole = at_time(scene, 50).state_hash();
  Simulation looked_at(scene);
  for (int frame = 1; frame <= 1500; ++frame) looked_at.advance_to(frame / 30.0);
  EXPECT_EQ(looked_at.state_hash(), whole);
  for (const double stop : {1.0, 12.0, 19.0, 27.0, 45.0}) {
    EXPECT_EQ(at_time(at_time(scene, stop).save(), 50).state_hash(), whole) << stop;
  }
  Scene shared = scene;
  shared.workers = 3;
  EXPECT_EQ(at_time(shared, 50).state_hash(), whole);
}

// Counts and turns go on over the moment at which the first ball comes to rest.  Along the
// periodic axis the ball falls for ever, at last at g / k.
TEST(EventDragRest, energy_and_counts_go_on_when_balls_come_to_rest) {
  const double g = 1;
  const double k = 0.5;
  Scene scene = elastic({g, -5}, k);
  scene.box.periodic = {true, false};
  scene.balls = {ball(2, 1.5)};
  Simulation run(scene);
  run.advance_to(5);
  const std::uint64_t bounces = run.measure().ball_wall;
  EXPECT_GT(bounces, 2U);
  run.advance_to(60);
  EXPECT_GT(run.measure().ball_wall, bounces);
  ASSERT_EQ(run.state()[0].position.y(), 0.5);
  const double fading = -std::expm1(-k * 60);
  const double v = g / k * fading;
  const double x = 2 + g / k * (60 - fading / k);
  const double energy = v * v / 2 - g * x + 5 * 0.5;
  EXPECT_NEAR(run.measure().energy_final, energy, 1e-12 * std::abs(energy));
}

// A stack that slides along a floor of ice falls along it at g / k (1 - exp(-k t)); the steps in
// which it is moved change that by g h at most, and nothing in the energy book.
// Seen to fail where a step took what a ball falls, and gains, within it as if there were no drag.
TEST(EventDragRest, an_island_falls_through_drag_by_its_closed_form) {
  const double g = 1;
  const double k = 0.5;
  Scene scene = elastic({g, -5}, k);
  scene.box.periodic = {true, false};
  scene.effects.collisions->restitution = 0;
  scene.effects.walls->restitution = 0;
  scene.balls = {ball(2, 0.5), ball(2, 1.5)};
  for (const double time : {1.0, 2.7, 20.0}) {
    const Simulation run = at_time(scene, time);
    const double v = g / k * -std::expm1(-k * time);
    for (const Ball& b : run.state()) EXPECT_NEAR(b.velocity.x(), v, 0.01) << time;
    EXPECT_NEAR(run.state()[1].position.y(), 1.5, 1e-6) << time;
    EXPECT_LT(run.measure().relative_energy_error(), 1e-10) << time;
  }
}

TEST(EventDragRest, losses_under_gravity_with_drag_are_taken) {
  Scene scene = elastic({0, -9.81}, 0.2);
  scene.effects.walls->restitution = 0.7;
  scene.balls = {ball(3, 5, 1)};
  const std::vector<Ball> balls = at_time(scene, 20).state();
  EXPECT_EQ(balls[0].position.y(), 0.5);
  EXPECT_EQ(balls[0].velocity.y(), 0);
  // No wall slows it along the floor, drag does.
  EXPECT_NEAR(balls[0].velocity.x(), std::exp(-0.2 * 20), 1e-13);
  EXPECT_NEAR(balls[0].position.x(), 3 - std::expm1(-0.2 * 20) / 0.2, 1e-12);
}

// Light balls between a heavy one and walls that lose energy are hit ever faster: with nothing to
// stop it, without end.
TEST(EventDragRest, what_is_squeezed_against_lossy_walls_is_not_hit_for_ever) {
  Scene scene;
  scene.box.width = 3;
  scene.box.height = 1;
  scene.effects.walls = Walls{0.9};
  scene.effects.collisions = Collisions{};
  scene.effects.gravity = Gravity{{-1.7776107788085938, -8.915328979492188}};
  scene.solver.method = Method::event;
  scene.workers = 1;
  scene.balls = {ball(0.5, 0.5, -3.9863128662109375, -1.50189208984375),
                 ball(1.5, 0.5, -1.5914535522460938, -0.5870132446289062),
                 ball(2.5, 0.5, 0.0214996337890625, -1.577911376953125)};
  scene.balls[0].radius = scene.balls[1].radius = 0.25;
  scene.balls[0].mass = 80;
  scene.balls[2].radius = 0.45;
  scene.balls[2].mass = 0.05;
  const Simulation run = at_time(scene, 10);
  EXPECT_LT(run.measure().ball_ball + run.measure().ball_wall, 100000U);
  EXPECT_LT(run.measure().energy_final, run.measure().energy_initial);
}

}  // namespace
}  // namespace carom::event_drag_rest_test
