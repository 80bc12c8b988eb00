#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "carom/session.hpp"
#include "solvers/overlap/solver.hpp"
#include "support/scenes.hpp"

namespace carom::overlap_test {
namespace {

struct Case {
  std::string name;
  Scene scene;
  double time;
};

Scene with_fixed_disks() {
  Scene scene = test::walled_gas(6, 6, 0.3);
  scene.effects.gravity = Gravity{{0.5, -9.81}};
  scene.effects.collisions->restitution = 0.8;
  for (std::size_t i = 0; i < scene.balls.size(); i += 5) {
    scene.balls[i].fixed = true;
    scene.balls[i].velocity = {0, 0};
  }
  return scene;
}

Scene scripted() {
  Scene scene = test::walled_gas(5, 5, 0.2);
  scene.effects.gravity = Gravity{{0, -9.81}};
  scene.box.height += 4;
  const double top = scene.box.height - 1;
  command::SetEffects still;
  still.effects.gravity = Gravity{{0, 0}};
  scene.script = {{0.3, command::Add{Ball{{2, top}}}},
                  {0.41, command::Remove{3}},
                  {0.5, command::Pause{}},
                  {0.75, command::Resume{}},
                  {0.9, still},
                  {1.1, command::SetStep{1.0 / 500}},
                  {1.3, command::Remove{}}};
  return scene;
}

// Begins with all pairs cached, goes on with a list of neighbours, and comes back.
Scene growing() {
  Scene scene = test::walled_gas(7, 9, 0.3);
  scene.box.height += 2;
  const double top = scene.box.height - 1;
  scene.script = {{0.1, command::Add{Ball{{2, top}}}},
                  {0.2, command::Add{Ball{{5, top}, {0, -4}}}},
                  {0.4, command::Remove{}},
                  {0.4, command::Remove{7}}};
  return scene;
}

std::vector<Case> cases() {
  return {{"few balls", test::walled_gas(4, 4, 0.4), 1.5},
          {"dense and periodic", test::gas(8, 9, 0.85), 0.25},
          {"pile", test::pile(65, 0.2, 12), 0.75},
          {"pegs", with_fixed_disks(), 1},
          {"script", scripted(), 1.5},
          {"growing", growing(), 0.5}};
}

std::string run(Scene scene, double time, double frame_rate) {
  Session session(std::move(scene));
  for (int frame = 1; frame <= time * frame_rate; ++frame) {
    session.advance_clock_to(frame / frame_rate);
  }
  session.advance_clock_to(time);
  return session.simulation().state_hash();
}

TEST(Determinism, AnyNumberOfWorkersGivesTheSameBits) {
  for (const Case& c : cases()) {
    Scene scene = c.scene;
    scene.workers = 1;
    const std::string expected = run(scene, c.time, 30);
    for (const std::size_t workers : {2, 3, 7}) {
      scene.workers = workers;
      EXPECT_EQ(run(scene, c.time, 30), expected) << c.name << ", workers " << workers;
    }
    scene.workers.reset();
    scene.per_ball = true;
    EXPECT_EQ(run(scene, c.time, 30), expected) << c.name << ", a worker for each ball";
  }
}

TEST(Determinism, WorkSharedOutBetweenPhasesGivesTheSameBits) {
  // Enough balls that the search for neighbours, enough impacts that their groups are shared out.
  Scene scene = test::gas(50, 50, 0.7);
  scene.solver.step = 1.0 / 30;
  const std::string expected = run(scene, 0.5, 30);
  scene.workers = 3;
  Session session(scene);
  session.advance_clock_to(0.5);
  EXPECT_EQ(session.simulation().state_hash(), expected);
  for (const auto& [name, seconds] : session.simulation().measure().phases) {
    EXPECT_GT(seconds, 0) << name << " was never shared out";
  }
}

TEST(Determinism, AnyFrameRateGivesTheSameBits) {
  for (const Case& c : cases()) {
    const std::string expected = run(c.scene, c.time, 30);
    for (const double rate : {1.0, 7.0, 333.3}) {
      EXPECT_EQ(run(c.scene, c.time, rate), expected) << c.name << ", rate " << rate;
    }
  }
}

TEST(Determinism, ASavedRunGoesOnToTheSameBits) {
  for (const Case& c : cases()) {
    const std::string expected = run(c.scene, c.time, 30);
    for (const double part : {0.1, 0.31, 0.5}) {
      Session first(c.scene);
      first.advance_clock_to(part * c.time);
      Session second(first.save());
      EXPECT_DOUBLE_EQ(second.simulation().time(), first.simulation().time());
      second.advance_clock_to(c.time);
      EXPECT_EQ(second.simulation().state_hash(), expected) << c.name << ", at " << part;
    }
  }
}

// One worker's part of a solver, without a crew.
std::string run_alone(const Scene& scene, double time, OverlapSolver::Pairs pairs) {
  OverlapSolver solver(scene, scene.balls, pairs);
  const std::vector<Phase> phases = solver.phases();
  std::size_t phase = solver.aim(time);
  while (phase != Phase::kFrameDone) {
    phases[phase].work(Share{});
    phase = phases[phase].finish();
  }
  return solver.state_hash();
}

TEST(Determinism, AllPairsAndNeighbourListsGiveTheSameBits) {
  std::vector<Case> scenes = cases();
  scenes.push_back({"bullet", test::walled_gas(6, 6, 0.3), 1});
  scenes.back().scene.balls[7].velocity = {900, 700};
  scenes.push_back({"open", test::walled_gas(6, 6, 0.3), 6});
  scenes.back().scene.effects.walls.reset();
  Scene mixture = test::walled_gas(8, 8, 0.3);
  for (std::size_t i = 0; i < mixture.balls.size(); i += 3) mixture.balls[i].radius = 0.05;
  scenes.push_back({"mixture", mixture, 3});
  for (const Case& c : scenes) {
    EXPECT_EQ(run_alone(c.scene, c.time, OverlapSolver::Pairs::all),
              run_alone(c.scene, c.time, OverlapSolver::Pairs::neighbours))
        << c.name;
  }
}

}  // namespace
}  // namespace carom::overlap_test
