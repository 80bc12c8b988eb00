#include "carom/session.hpp"

#include <gtest/gtest.h>

#include "carom/scene_file.hpp"

namespace carom::session_test {
namespace {

Scene one_ball() {
  Scene scene;
  scene.effects.walls = Walls{};
  scene.effects.collisions = Collisions{};
  scene.solver.method = Method::overlap;
  scene.solver.step = 1.0 / 64;
  scene.balls.push_back(Ball{{5, 5}, {1, 0}});
  return scene;
}

double x_of(const Session& session, std::size_t ball = 0) {
  return session.simulation().state()[ball].position.x();
}

TEST(Session, ObeysItsScriptAtTheExactTimeBetweenFrames) {
  Scene scene = one_ball();
  scene.script = {{0.25, command::Pause{}}, {0.5, command::Resume{}}, {1.5, command::Quit{}}};
  Session session(scene);
  session.advance_clock_to(1);
  EXPECT_EQ(x_of(session), 5.75);
  EXPECT_EQ(session.simulation().time(), 0.75);
  EXPECT_FALSE(session.quit());
  session.advance_clock_to(10);
  EXPECT_TRUE(session.quit());
  EXPECT_EQ(x_of(session), 6.25);
}

// Seen to fail: with each line obeyed after those that are due at the same time.
TEST(Session, ObeysLinesOfOneTimeInTheirOrder) {
  Scene scene = one_ball();
  scene.script = {{0.5, command::Pause{}}, {0.5, command::Resume{}}};
  Session session(scene);
  session.advance_clock_to(1);
  EXPECT_EQ(x_of(session), 6);
  EXPECT_FALSE(session.paused());
}

TEST(Session, StandsStillWhilePausedButCanBeNudged) {
  Session session(one_ball());
  session.apply(command::Pause{});
  session.advance_clock_to(1);
  EXPECT_EQ(x_of(session), 5);
  EXPECT_TRUE(session.stuck());
  session.nudge(0.5);
  EXPECT_EQ(x_of(session), 5.5);
  session.apply(command::Resume{});
  session.advance_clock_to(1.25);
  EXPECT_EQ(x_of(session), 5.75);
}

TEST(Session, GoesOnFromASavedScenePausedWithTheRestOfItsScript) {
  Scene scene = one_ball();
  scene.script = {{0.25, command::Pause{}}, {1, command::Resume{}}};
  Session first(scene);
  first.advance_clock_to(0.5);
  const Scene saved = first.save();
  ASSERT_EQ(saved.script.size(), 1U);
  Session second(saved);
  EXPECT_TRUE(second.paused());
  EXPECT_EQ(second.clock(), 0.5);
  second.advance_clock_to(1.5);
  EXPECT_EQ(x_of(second), 5.75);
}

// Times that no double holds, so that sums in another order end otherwise.
Scene with_two_pauses() {
  Scene scene = one_ball();
  scene.solver.method = Method::event;
  scene.balls[0].velocity = {0.3, 0.7};
  scene.script = {{0.225, command::Pause{}},
                  {0.6667323249479433, command::Resume{}},
                  {0.7, command::Pause{}},
                  {1.1, command::Resume{}}};
  return scene;
}

TEST(Session, APauseEndsAtTheSameInstantAtEveryFrameRate) {
  Session whole(with_two_pauses());
  whole.advance_clock_to(2);
  for (const double rate : {3.0, 7.0, 30.0, 240.0, 1000.0 / 3}) {
    Session session(with_two_pauses());
    for (int frame = 1; frame / rate < 2; ++frame) session.advance_clock_to(frame / rate);
    session.advance_clock_to(2);
    EXPECT_EQ(write_scene(session.save()), write_scene(whole.save())) << rate;
  }
}

TEST(Session, SavedAtAnyMomentItEndsWithTheSameSave) {
  Session whole(with_two_pauses());
  whole.advance_clock_to(2);
  for (const double stop : {0.0, 0.1, 0.3, 0.6667323249479433, 0.69, 0.9, 1.1, 1.3}) {
    Session first(with_two_pauses());
    first.advance_clock_to(stop);
    Session second(parse_scene(write_scene(first.save()), "saved"));
    EXPECT_EQ(second.clock(), first.clock());
    EXPECT_EQ(second.simulation().time(), first.simulation().time());
    second.advance_clock_to(2);
    EXPECT_EQ(write_scene(second.save()), write_scene(whole.save())) << stop;
  }
}

TEST(Simulation, RefusesABallWithoutRoomAndStaysAsItIs) {
  Session session(one_ball());
  const std::string before = session.simulation().state_hash();
  EXPECT_THROW(session.apply(command::Add{Ball{{5.5, 5}}}), CommandError);
  EXPECT_THROW(session.apply(command::Add{Ball{{0.1, 5}}}), CommandError);
  EXPECT_THROW(session.apply(command::Remove{7}), CommandError);
  EXPECT_THROW(session.apply(command::SetStep{-1}), CommandError);
  command::SetEffects drag;
  drag.effects.gravity = Gravity{};
  EXPECT_THROW(session.apply(drag), CommandError);
  EXPECT_EQ(session.simulation().state_hash(), before);
  EXPECT_EQ(session.simulation().balls(), 1U);
}

TEST(Simulation, AddsAndRemovesBallsWithTheirWorkersAndAccountsForTheirEnergy) {
  Scene scene = one_ball();
  scene.played = true;
  Session session(scene);
  EXPECT_EQ(session.simulation().workers(), 1U);
  session.apply(command::Add{Ball{{2, 2}, {2, 0}}});
  EXPECT_EQ(session.simulation().workers(), 2U);
  EXPECT_EQ(session.simulation().measure().energy_input, 2);
  session.advance_clock_to(0.5);
  EXPECT_EQ(x_of(session, 1), 3);
  session.apply(command::Remove{0});
  EXPECT_EQ(session.simulation().workers(), 1U);
  EXPECT_EQ(session.simulation().measure().energy_input, 1.5);
  EXPECT_EQ(x_of(session), 3);
  session.apply(command::Remove{});
  EXPECT_EQ(session.simulation().balls(), 0U);
  session.advance_clock_to(1);
}

TEST(Simulation, ANewStepCountsFromTheLastStepTaken) {
  Session session(one_ball());
  session.advance_clock_to(0.5 + 1.0 / 128);
  session.apply(command::SetStep{1.0 / 4});
  session.advance_clock_to(0.74);
  EXPECT_EQ(x_of(session), 5.5);
  session.advance_clock_to(0.75);
  EXPECT_EQ(x_of(session), 5.75);
}

TEST(Simulation, SimulatesOnlyTheEffectsThatAreNamed) {
  Scene scene = one_ball();
  scene.effects.walls.reset();
  scene.effects.collisions.reset();
  scene.balls.push_back(Ball{{7, 5}, {-1, 0}});
  Session session(scene);
  session.advance_clock_to(16);
  EXPECT_EQ(x_of(session, 0), 21);
  EXPECT_EQ(x_of(session, 1), -9);
  const Measurements measurements = session.simulation().measure();
  ASSERT_EQ(measurements.phases.size(), 1U);
  EXPECT_EQ(measurements.phases.front().first, "flight");
  EXPECT_TRUE(measurements.effects.empty());
}

TEST(Simulation, AFrameOrEndBetweenStepsShowsTheLatestStep) {
  Session session(one_ball());
  session.advance_clock_to(0.99 / 64);
  EXPECT_EQ(x_of(session), 5);
  session.advance_clock_to(1.0 / 64);
  EXPECT_EQ(x_of(session), 5 + 1.0 / 64);
}

}  // namespace
}  // namespace carom::session_test
