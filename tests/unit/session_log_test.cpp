// What was done, as a scene with a script: a run of it ends in the same bits.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "carom/session.hpp"
#include "options.hpp"
#include "schedule.hpp"

namespace carom::session_log_test {
namespace {

Scene box_with(Method method, bool attraction) {
  Scene scene;
  scene.box.width = 10;
  scene.box.height = 8;
  scene.effects.walls = Walls{0.9};
  scene.effects.collisions = Collisions{0.95};
  scene.effects.gravity = Gravity{{0, -1}};
  if (attraction) scene.effects.attraction = Attraction{0.1, 0.5};
  scene.solver.method = method;
  Fill fill;
  fill.count = 12;
  fill.radius = 0.4;
  fill.temperature = 2;
  scene.fills = {fill};
  scene.script = {{0.7, command::SetEffects{}}};
  std::get<command::SetEffects>(scene.script[0].command).effects.gravity = Gravity{{0.3, -2}};
  return scene;
}

/// A person at the keys, with frames of uneven length.
void play(Session& session) {
  double clock = session.clock();
  const auto frames = [&](int count, double length) {
    for (int k = 0; k < count; ++k) session.advance_clock_to(clock += length);
  };
  frames(13, 0.0371);
  session.apply(command::Remove{2});
  frames(7, 0.0193);
  session.apply(command::Pause{});
  frames(5, 0.033);
  session.nudge(0.0333);
  Ball ball;
  ball.radius = 0.01;
  ball.position = {0.011, 7.98};
  ball.velocity = {1, 1};
  session.apply(command::Add{ball});
  frames(2, 0.033);
  session.apply(command::Resume{});
  frames(20, 0.0471);
  command::SetEffects set;
  set.effects.walls = Walls{0.5};
  session.apply(set);
  frames(3, 0.0333);
  session.apply(command::Remove{});
  frames(9, 0.0017);
}

std::string hash_of_run(const Scene& scene) {
  Session session(scene);
  Schedule schedule(session, Options{});
  while (schedule.next_frame()) {
  }
  return session.simulation().state_hash();
}

TEST(SessionLog, ARunOfItEndsInTheSameBits) {
  for (const bool attraction : {false, true}) {
    for (const Method method : {Method::event, Method::overlap}) {
      Session session(box_with(method, attraction));
      play(session);
      // As it is written and read.
      const Scene log = parse_scene(write_scene(session.log()), "log");
      EXPECT_EQ(log.script.size(), 5U);
      EXPECT_EQ(hash_of_run(log), session.simulation().state_hash());
    }
  }
}

TEST(SessionLog, OfARunThatGoesOnBeginsWhereThatStood) {
  for (const Method method : {Method::event, Method::overlap}) {
    Session first(box_with(method, false));
    first.advance_clock_to(0.3137);
    Session session(first.save());
    play(session);
    const Scene log = parse_scene(write_scene(session.log()), "log");
    EXPECT_EQ(hash_of_run(log), session.simulation().state_hash());
  }
}

}  // namespace
}  // namespace carom::session_log_test
