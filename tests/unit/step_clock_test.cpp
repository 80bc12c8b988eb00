#include "solvers/event/step_clock.hpp"

#include <gtest/gtest.h>

#include <random>

namespace carom::event::step_clock_test {
namespace {

/// The first multiple of 2^shift that is not before `now` and after `last`, by going there tick by
/// tick.
FixedTime slowly(FixedTime now, int shift, FixedTime last) {
  FixedTime at = now;
  while (at % (FixedTime{1} << shift) != 0 || (at == now && last >= now)) ++at;
  return at;
}

TEST(StepClock, StepsAtMultiplesOfItsStepEachOnceAtMost) {
  std::mt19937 random(2);
  StepClock<FixedTimeClock> clock;
  FixedTime now = 0;
  FixedTime last = 0;
  clock.reset(0);
  int at_once = 0;
  for (int round = 0; round < 5000; ++round) {
    ASSERT_FALSE(clock.runs());
    const int shift = static_cast<int>(random() % 4);
    clock.start(now, shift);
    ASSERT_TRUE(clock.runs());
    ASSERT_EQ(clock.next(), slowly(now, shift, last)) << now << ' ' << shift << ' ' << last;
    if (clock.next() == now) ++at_once;
    const FixedTime next = clock.next();
    clock.start(now, 10);  // it runs already
    ASSERT_EQ(clock.next(), next);
    now = last = next;
    clock.take();
    now += static_cast<FixedTime>(random() % 5);
    if (round % 50 != 49) continue;
    const FixedTime by = last;
    clock.rebase(by);
    now -= by;
    last -= by;
  }
  EXPECT_GT(at_once, 100);
}

TEST(StepClock, CountsTheNextStepFromLaterOn) {
  StepClock<FixedTimeClock> clock;
  clock.reset(0);
  clock.start(5, 4);
  ASSERT_EQ(clock.next(), 16);
  clock.rebase(8);
  EXPECT_EQ(clock.next(), 8);
  clock.take();
  clock.start(8, 3);
  EXPECT_EQ(clock.next(), 16);  // not at 8 again
  clock.take();
  clock.rebase(32);
  clock.start(0, 3);  // what was in an earlier epoch is earlier
  EXPECT_EQ(clock.next(), 0);
}

TEST(StepClock, ForgetsItsStepsWhenTheBallsAreOthers) {
  StepClock<FixedTimeClock> clock;
  clock.reset(0);
  clock.start(5, 2);
  clock.reset(8);
  EXPECT_FALSE(clock.runs());
  clock.start(8, 2);
  EXPECT_EQ(clock.next(), 12);
}

}  // namespace
}  // namespace carom::event::step_clock_test
