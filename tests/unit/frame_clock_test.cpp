#include "carom/frame_clock.hpp"

#include <gtest/gtest.h>

namespace carom::frame_clock_test {
namespace {

TEST(FrameClock, StandsForSimulatedTimeLessThePauses) {
  FrameClock clock;
  clock.move_to(2);
  EXPECT_EQ(clock.time(), 2);
  clock.pause();
  clock.move_to(5);
  clock.pause();  // a second time changes nothing
  clock.resume(2);
  EXPECT_FALSE(clock.paused());
  clock.resume(7);  // there is no pause to end
  clock.move_to(6);
  EXPECT_EQ(clock.time(), 3);
  EXPECT_EQ(clock.at(4), 7);
}

TEST(FrameClock, GoesOnFromWhatItSaved) {
  FrameClock clock;
  clock.move_to(1);
  clock.pause();
  clock.move_to(1.5);
  clock.resume(1);
  clock.move_to(2.25);
  Continuation past;
  past.time = clock.time();
  clock.save(past);
  FrameClock other(past);
  for (FrameClock* each : {&clock, &other}) each->move_to(0.1 + 8);
  EXPECT_EQ(other.time(), clock.time());
}

// Files of runs that were never paused, or saved while paused, hold no origins.
TEST(FrameClock, KnowsTheOriginsThatAFileLeavesOut) {
  Continuation past;
  past.time = past.clock = 3;
  FrameClock never(past);
  never.move_to(0.1);
  EXPECT_EQ(never.time(), 0.1);
  past.clock = 4;
  FrameClock later(past);
  later.move_to(6);
  EXPECT_EQ(later.time(), 5);
  past.paused = true;
  Continuation saved;
  FrameClock(past).save(saved);
  EXPECT_TRUE(saved.paused);
  EXPECT_FALSE(saved.clock_origin.has_value() || saved.time_origin.has_value());
}

}  // namespace
}  // namespace carom::frame_clock_test
