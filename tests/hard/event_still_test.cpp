// Method event where nothing moves: time costs nothing, and what moves later has its own clock.
#include <gtest/gtest.h>

#include "carom/scene_file.hpp"
#include "carom/simulation.hpp"

namespace carom::event_still_test {
namespace {

Scene empty_box(double side) {
  Scene scene;
  scene.solver.method = Method::event;
  scene.workers = 1;
  scene.box.width = scene.box.height = side;
  scene.effects.walls = Walls{1};
  scene.effects.collisions = Collisions{1};
  return scene;
}

Ball ball_at(double x, double y, double radius) {
  Ball ball;
  ball.position = {x, y};
  ball.radius = radius;
  return ball;
}

// Broken, it does not end: time is counted on by some crossings of the box, one after the other.
TEST(EventStill, ALongTimePassesAtOnceWhereNothingMoves) {
  Scene scene = empty_box(3);
  scene.effects.friction = Friction{0.5, 0.5};
  scene.balls = {ball_at(1, 1, 0.5), ball_at(2, 1, 0.5)};
  scene.balls[0].spin = 2;  // there is nothing that it could slow down on
  scene.balls[1].fixed = true;
  for (const int workers : {1, 2}) {
    scene.workers = workers;
    Simulation simulation(scene);
    simulation.advance_to(1e15);
    EXPECT_EQ(simulation.time(), 1e15);
    EXPECT_EQ(simulation.state()[0].position, Vec2(1, 1));
    EXPECT_EQ(simulation.state()[0].spin, 2);
  }
}

// Broken, by a clock of seconds, it knows the times of impacts to 2^-55 s: to some percent of what
// the ball takes to cross this box.
TEST(EventStill, WhatMovesLaterHasAClockOfItsOwn) {
  constexpr double kSide = 1e-12;
  constexpr double kSpeed = 1000;
  Scene scene = empty_box(kSide);
  scene.duration = 1e-12;
  Simulation simulation(scene);
  Ball ball = ball_at(kSide / 2, kSide / 2, 0.3 * kSide);
  ball.velocity = {kSpeed, 0};
  simulation.apply(command::Add{ball});
  const Scene saved = parse_scene(write_scene(simulation.save()), "saved");
  const double time = 0.27 * kSide / kSpeed;  // 0.2 of the side to the wall, 0.07 back
  simulation.advance_to(time);
  EXPECT_NEAR(simulation.state()[0].position.x(), 0.63 * kSide, 1e-14 * kSide);
  Simulation again(saved);
  again.advance_to(time);
  EXPECT_EQ(again.state_hash(), simulation.state_hash());
}

}  // namespace
}  // namespace carom::event_still_test
