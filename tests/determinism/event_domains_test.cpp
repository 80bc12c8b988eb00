#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "carom/crew.hpp"
#include "carom/scene_file.hpp"
#include "carom/session.hpp"
#include "solvers/event/solver.hpp"
#include "support/run_outcome.hpp"
#include "support/scenes.hpp"

namespace carom::event_domains_test {
namespace {

struct Case {
  std::string name;
  Scene scene;
  double time;
};

using Outcome = test::RunOutcome;

struct Run {
  std::size_t workers = 1;
  double frame_rate = 30;
};

/// No workers: by one event loop.
Outcome run(const Case& c, const Run& how, std::uint64_t* again = nullptr) {
  const event::Sharing always{0, 0};
  const event::Sharing never{static_cast<std::size_t>(-1), 0};
  Scene scene = c.scene;
  scene.workers = std::max<std::size_t>(how.workers, 1);
  EventSolver solver(scene, scene.balls, how.workers > 0 ? always : never);
  Crew crew(*scene.workers, solver.phases());
  const auto go_to = [&](double time) {
    const std::size_t first = solver.aim(time);
    if (first != Phase::kFrameDone) crew.do_frame(first);
  };
  for (int frame = 1; frame < c.time * how.frame_rate; ++frame) go_to(frame / how.frame_rate);
  go_to(c.time);
  if (again != nullptr) {
    Measurements measured;
    solver.count(measured);
    *again += measured.islands_again;
  }
  return test::outcome_of(solver);
}

Scene falling() {
  Scene scene = test::walled_gas(24, 40, 0.4);
  scene.effects.gravity = Gravity{{0.1, -0.5}};
  return scene;
}

Scene two_sizes() {
  Scene scene = test::gas(30, 30, 0.6);
  for (std::size_t i = 0; i < scene.balls.size(); i += 3) {
    scene.balls[i].radius = 0.25;
    scene.balls[i].mass = 0.125;
  }
  for (std::size_t i = 7; i < scene.balls.size(); i += 50) {
    scene.balls[i].fixed = true;
    scene.balls[i].velocity = {0, 0};
  }
  return scene;
}

// All balls meet at the same instants, many at a time, in every domain and across every border.
Scene in_step() {
  Scene scene = test::walled_gas(1, 1, 0.5);
  scene.balls.clear();
  scene.box.width = 48;
  scene.box.height = 40;
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 24; ++column) {
      Ball ball;
      ball.position = {2.0 * column + 1, 2.0 * row + 1};
      ball.velocity = {(column + row) % 2 == 0 ? 1.0 : -1.0, row % 3 == 0 ? 0.5 : -0.5};
      scene.balls.push_back(ball);
    }
  }
  return scene;
}

// An impact runs along touching balls from one end of the box to the other, through all domains.
Scene chain() {
  Scene scene = in_step();
  scene.balls.clear();
  scene.box.width = 64;
  scene.box.height = 8;
  for (int i = 0; i < 50; ++i) scene.balls.push_back(Ball{{i + 8.0, 4}});
  scene.balls.push_back(Ball{{2, 4}, {3, 0}});
  scene.balls.push_back(Ball{{30, 6.5}, {0.3, 0.7}});
  scene.balls.push_back(Ball{{50, 1.5}, {-0.3, 0.7}});
  return scene;
}

// One ball crosses many domains while the others hardly move.
Scene bullet() {
  Scene scene = test::gas(30, 30, 0.3);
  scene.balls[435].velocity = {4000, 1500};
  return scene;
}

// Impacts take energy and nothing presses balls together: a granular gas.
Scene granular(Scene scene, double restitution) {
  scene.effects.collisions->restitution = restitution;
  return scene;
}

// Balls so close that impacts follow each other ever faster, and some stay together.
Scene collapsing() {
  Scene scene = granular(test::gas(14, 16, 0.75), 0.1);
  scene.effects.friction = Friction{0.3, 0};
  return scene;
}

// What falls is solved in domains until the first ball comes to rest.
Scene raining(double friction) {
  Scene scene = granular(test::walled_gas(40, 12, 0.2), 0.7);
  scene.effects.walls->restitution = 0.3;
  scene.effects.gravity = Gravity{{0.1, -4}};
  if (friction > 0) scene.effects.friction = Friction{friction, friction};
  return scene;
}

// The same with drag, and on fixed balls: some come to lie on these.
Scene raining_on_fixed(double friction, double drag) {
  Scene scene = raining(friction);
  for (std::size_t i = 5; i < scene.balls.size(); i += 16) {
    scene.balls[i].fixed = true;
    scene.balls[i].velocity = {0, 0};
  }
  if (drag > 0) scene.effects.drag = Drag{drag};
  return scene;
}

Scene falling_with_drag() {
  Scene scene = falling();
  scene.effects.drag = Drag{0.3};
  return scene;
}

// Each straight above a fixed ball, on which only drag brings it to rest.
Scene dropping_on_fixed() {
  Scene scene = falling();
  scene.effects.gravity = Gravity{{0, -8}};
  scene.effects.drag = Drag{6};
  scene.balls.clear();
  for (int column = 0; column < 12; ++column) {
    const double x = 1 + 1.5 * column;
    scene.balls.push_back(Ball{{x, 1}});
    scene.balls.back().fixed = true;
    scene.balls.push_back(Ball{{x, 3 + 0.1 * column}});
  }
  return scene;
}

std::vector<Case> cases() {
  return {{"gas", test::gas(36, 40, 0.5), 1},
          {"thin gas", test::gas(36, 40, 0.05), 8},
          {"dense and walled", test::walled_gas(30, 34, 0.82), 0.3},
          {"falling", falling(), 1.5},
          {"two sizes and fixed balls", two_sizes(), 0.7},
          {"in step", in_step(), 2},
          {"chain", chain(), 30},
          {"bullet", bullet(), 0.2},
          {"granular", granular(test::gas(30, 34, 0.5), 0.8), 2},
          {"granular and walled", granular(test::walled_gas(30, 34, 0.6), 0.5), 1.5},
          {"collapsing", collapsing(), 0.2},
          {"raining", raining(0), 2.5},
          {"raining, with friction", raining(0.4), 2.5},
          {"raining on fixed balls", raining_on_fixed(0, 0), 2.5},
          {"raining on fixed balls, with friction and drag", raining_on_fixed(0.4, 0.2), 2.5},
          {"falling with drag", falling_with_drag(), 1.5},
          {"dropping on fixed balls", dropping_on_fixed(), 4.5}};
}

TEST(EventDomains, OfAnyNumberOfWorkersGiveTheBitsOfOneEventLoop) {
  std::uint64_t again = 0;
  for (const Case& c : cases()) {
    const Outcome expected = run(c, {0});
    EXPECT_GT(expected.ball_ball, 100U) << c.name;
    if (c.scene.effects.gravity && loses_energy(c.scene)) {
      EXPECT_GT(expected.resting_contacts, 0U) << c.name;
    }
    for (const std::size_t workers : {1, 2, 3, 7}) {
      EXPECT_EQ(run(c, {workers}, &again), expected) << c.name << ", " << workers << " workers";
      EXPECT_EQ(run(c, {workers, 2}, &again), expected)
          << c.name << ", long frames, " << workers << " workers";
    }
  }
  EXPECT_GT(again, 0U) << "no domain was ever solved again";
}

TEST(EventDomains, AnyFrameRateGivesTheSameBits) {
  const Case gas{"gas", test::gas(36, 40, 0.5), 1};
  const Case drop{"falling", falling(), 1};
  for (const Case& c : {gas, drop}) {
    const Outcome expected = run(c, {0});
    for (const double rate : {1.0, 7.0, 60.0, 333.3, 1000.0}) {
      EXPECT_EQ(run(c, {2, rate}), expected) << c.name << ", rate " << rate;
    }
  }
}

// Enough balls that the solver shares the plane by itself.
TEST(EventDomains, WorkersOfASessionGiveTheSameBits) {
  Scene scene = test::gas(70, 60, 0.4);
  scene.solver.method = Method::event;
  scene.script = {{0.11, command::Remove{1000}}, {0.2, command::Remove{}}};
  std::string expected;
  for (const std::size_t workers : {1, 2, 3, 7, 40}) {
    scene.workers = workers;
    Session session(scene);
    for (const double time : {0.05, 0.1, 0.12, 0.2, 0.5}) session.advance_clock_to(time);
    if (workers == 1) expected = session.simulation().state_hash();
    EXPECT_EQ(session.simulation().state_hash(), expected) << workers << " workers";
    EXPECT_EQ(session.simulation().measure().phases.size(), 3U);
  }
}

TEST(EventDomains, WorkersThatStopAndGoOnInOtherNumbersGiveTheSameBits) {
  Scene scene = test::gas(70, 60, 0.4);
  scene.solver.method = Method::event;
  scene.workers = 1;
  Simulation whole(scene);
  whole.advance_to(0.4);
  for (const double stop : {0.0123, 0.31}) {
    scene.workers = 2;
    Simulation first(scene);
    first.advance_to(stop);
    Scene saved = parse_scene(write_scene(first.save()), "saved");
    saved.workers = 3;
    Simulation second(saved);
    second.advance_to(0.4);
    EXPECT_EQ(second.state_hash(), whole.state_hash()) << stop;
  }
}

}  // namespace
}  // namespace carom::event_domains_test
