// One event loop whose contact islands several workers solve: the bits and counts of one worker.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <random>
#include <vector>

#include "carom/crew.hpp"
#include "carom/scene.hpp"
#include "solvers/event/solver.hpp"
#include "support/run_outcome.hpp"

namespace carom::event_islands_test {
namespace {

using Outcome = test::RunOutcome;

constexpr int kPits = 5;

/// Balls fall into pits between columns of fixed balls and become a heap in each.
Scene pits(double friction) {
  constexpr double kWidth = 4;
  constexpr double kThin = 0.2;
  Scene scene;
  scene.box.width = kPits * kWidth;
  scene.box.height = 30;
  scene.effects.walls = Walls{0.4};
  scene.effects.collisions = Collisions{0.5};
  scene.effects.gravity = Gravity{};
  if (friction > 0) scene.effects.friction = Friction{friction, friction};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-0.04, 0.04);
  for (int pit = 0; pit < kPits; ++pit) {
    for (int k = 0; k < 40; ++k) {
      Ball ball;
      ball.radius = 0.3;
      ball.mass = 0.36;
      ball.position = {pit * kWidth + 0.7 + 0.65 * (k % 5) + off(random), 1 + 0.7 * (k / 5)};
      ball.velocity = {off(random), off(random)};
      scene.balls.push_back(ball);
    }
    for (int k = 0; pit > 0 && k < 15; ++k) {
      Ball ball;
      ball.radius = kThin;
      ball.position = {pit * kWidth, kThin + 2 * kThin * k};
      ball.fixed = true;
      scene.balls.push_back(ball);
    }
  }
  return scene;
}

/// How often a worker has begun a phase.
struct Begun {
  int flying = 0;   ///< in which each flies its own balls
  int sharing = 0;  ///< in which islands or pairs are shared
};

Outcome run(Scene scene, std::size_t workers, double frame_rate, Begun* counted = nullptr) {
  constexpr double kTime = 1;
  event::Sharing one_loop;
  one_loop.least_balls = static_cast<std::size_t>(-1);
  one_loop.balls_of_one_loop = 0;
  scene.workers = workers;
  EventSolver solver(scene, scene.balls, one_loop);
  std::vector<Phase> phases = solver.phases();
  std::array<std::atomic<int>, 2> begun{};
  for (std::size_t k = 0; k < begun.size(); ++k) {
    phases[k].work = [&count = begun[k], work = phases[k].work](Share share) {
      ++count;
      work(share);
    };
  }
  Crew crew(workers, phases);
  for (int frame = 1; frame <= kTime * frame_rate; ++frame) {
    const std::size_t first = solver.aim(frame / frame_rate);
    if (first != Phase::kFrameDone) crew.do_frame(first);
  }
  if (counted != nullptr) *counted = {begun[0], begun[1]};
  return test::outcome_of(solver);
}

TEST(EventIslands, OfOneStepAreSolvedByAnyNumberOfWorkersWithTheSameBits) {
  const Scene scene = pits(0.3);
  Begun begun;
  const Outcome expected = run(scene, 1, 30, &begun);
  EXPECT_EQ(begun.sharing, 0);
  EXPECT_GT(expected.resting_contacts, 5U);
  for (const std::size_t workers : {2, 3, 7}) {
    EXPECT_EQ(run(scene, workers, 30, &begun), expected) << workers << " workers";
    EXPECT_GT(begun.sharing, 50) << workers << " workers";
    EXPECT_EQ(begun.flying, 0) << workers << " workers";
  }
  EXPECT_EQ(run(scene, 2, 7), expected) << "long frames";
}

// Seen to fail where the one loop did not ask how many workers there are.
TEST(EventIslands, BallsThatHaveAWorkerEachAreFlownByTheirs) {
  const Scene scene = pits(0);
  const auto movers = static_cast<std::size_t>(std::count_if(
      scene.balls.begin(), scene.balls.end(), [](const Ball& ball) { return !ball.fixed; }));
  Begun begun;
  const Outcome expected = run(scene, 1, 30);
  EXPECT_EQ(run(scene, movers, 30, &begun), expected);
  EXPECT_GE(begun.flying, 30 * static_cast<int>(movers));
}

}  // namespace
}  // namespace carom::event_islands_test
