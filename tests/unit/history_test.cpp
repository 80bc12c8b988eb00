// The way back: any moment again, in bounded memory.
#include "view/history.hpp"

#include <gtest/gtest.h>

#include "carom/scene_file.hpp"

namespace carom::history_test {
namespace {

/// Time that passes with each look.
class Clock : public UserInterface {
 public:
  [[nodiscard]] Size size() const override { return {80, 24}; }
  void show(const Canvas& /*canvas*/) override {}
  Event wait_until(Instant /*deadline*/) override { return {}; }
  [[nodiscard]] Instant now() const override { return now_ += std::chrono::milliseconds{50}; }

 private:
  mutable Instant now_;
};

Scene gas(std::size_t balls, Method method) {
  Scene scene;
  scene.box = {60, 60};
  scene.effects.walls.emplace();
  scene.effects.collisions.emplace();
  scene.solver.method = method;
  scene.workers = 1;
  Fill fill;
  fill.count = balls;
  fill.radius = 0.2;
  fill.temperature = 1;
  scene.fills = {fill};
  return scene;
}

TEST(History, AnyMomentComesAgainWithTheSameBits) {
  for (const Method method : {Method::event, Method::overlap}) {
    const Clock clock;
    auto session = std::make_unique<Session>(gas(60, method));
    History history;
    history.begin(*session, clock.now());
    std::vector<std::string> hashes;
    for (int frame = 0; frame < 100; ++frame) {
      hashes.push_back(session->simulation().state_hash());
      if (frame == 40) session->apply(command::Remove{7});
      session->advance_clock_to(session->clock() + 1.0 / 30);
      history.note(*session, clock);
    }
    const double last = session->simulation().time();
    const std::string at_last = session->simulation().state_hash();
    for (const int frame : {99, 98, 41, 70, 3, 0}) {
      const double time = frame == 0 ? 0 : history.frame_before(last, 100 - frame);
      history.go_back(session, time);
      history.move_on(*session, time);
      EXPECT_EQ(session->simulation().time(), time);
      EXPECT_EQ(session->simulation().state_hash(), hashes[static_cast<std::size_t>(frame)])
          << frame;
      EXPECT_EQ(history.last(), last);
    }
    history.move_on(*session, 1e9);
    EXPECT_EQ(session->simulation().time(), last);
    EXPECT_EQ(session->simulation().state_hash(), at_last);
  }
}

TEST(History, FramesAreCountedFromAnyMoment) {
  const Clock clock;
  Session session(gas(2, Method::event));
  History history;
  history.begin(session, clock.now());
  for (const double time : {1.0, 2.0, 3.0}) {
    session.advance_clock_to(time);
    history.note(session, clock);
  }
  EXPECT_EQ(history.frame_before(3, 1), 2);
  EXPECT_EQ(history.frame_before(2.5, 1), 2);
  EXPECT_EQ(history.frame_before(2, 1), 1);
  EXPECT_EQ(history.frame_before(3, 10), 0);
  EXPECT_EQ(history.frame_before(1, -1), 2);
  EXPECT_EQ(history.frame_before(1.5, -1), 2);
  EXPECT_EQ(history.frame_before(1, -10), 3);
}

TEST(History, StaysWithinItsMemoryAndReachesBackToTheStart) {
  const Clock clock;
  Scene scene = gas(6000, Method::overlap);
  scene.effects.collisions.reset();
  auto session = std::make_unique<Session>(scene);
  const std::string start = session->simulation().state_hash();
  History history;
  history.begin(*session, clock.now());
  const std::size_t one = history.bytes();
  const std::size_t frames = 2 * History::kMostBytes / one;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    session->advance_clock_to(session->clock() + 0.01);
    // Long enough for a checkpoint to be due again.
    for (int i = 0; i < 60; ++i) (void)clock.now();
    history.note(*session, clock);
    ASSERT_LE(history.bytes(), History::kMostBytes);
  }
  EXPECT_GT(history.bytes(), History::kMostBytes / 2) << "it was full";
  EXPECT_EQ(history.first(), 0);
  history.go_back(session, 0);
  EXPECT_EQ(session->simulation().state_hash(), start);
}

}  // namespace
}  // namespace carom::history_test
