#include "solvers/event/groups/window_length.hpp"

#include <gtest/gtest.h>

#include "solvers/event/physics.hpp"

namespace carom::event::window_length_test {
namespace {

using Length = WindowLength<Ballistic>;

// 16 balls of diameter 1/2 in a box of 8 by 8: a pitch of 2, a gap of 3/2; at speed 3 they meet
// another one after a way of (3/2) (2) / (1/2) = 6, that is in 2 s.
Spacing spacing() {
  Box box;
  box.width = box.height = 8;
  return Spacing{16, 16 * 9.0, 16 * 0.5, Domain(box, true), {0, 0}};
}

constexpr double kTick = 0x1p-40;

FixedTime ticks(double seconds) {
  return static_cast<FixedTime>(seconds / kTick);
}

Length measured() {
  Length length;
  length.measure(spacing(), FixedTimeClock::of_tick(kTick));
  length.start_over();
  return length;
}

FixedTime next(Length& length) {
  return length.end(0, kNever);
}

TEST(Spacing, IsThatOfALatticeOfSquares) {
  const Spacing wide = spacing();
  EXPECT_EQ(wide.pitch, 2);
  EXPECT_EQ(wide.diameter, 0.5);
  EXPECT_EQ(wide.gap, 1.5);
  EXPECT_EQ(wide.speed, 3);
  EXPECT_EQ(wide.way(), 6);
  EXPECT_EQ(wide.margin({0, 0}), 0.25 * 0.5 + 0.35 * 1.5);
  EXPECT_EQ(wide.margin({0, 4}), 0.5);  // an eighth of a periodic axis at most
}

TEST(Spacing, GravityMakesFasterAndBallsAsLargeAsTheirPitchHaveAGap) {
  Box box;
  box.width = box.height = 8;
  const Spacing heavy(16, 16 * 9.0, 16 * 2.0, Domain(box, true), {0, -8});
  EXPECT_EQ(heavy.gap, 2.0 / 16);
  EXPECT_EQ(heavy.speed, 5);  // 9 + 8 times 2 is 25
}

TEST(WindowLength, IsAFifthOfTheTimeInWhichABallMeetsAnother) {
  Length length = measured();
  EXPECT_NEAR(static_cast<double>(next(length)), static_cast<double>(ticks(0.4)), 1);
}

TEST(WindowLength, EndsAtTheTargetAndIsNotLongerThanItsLimit) {
  Length length = measured();
  EXPECT_EQ(length.end(ticks(1), ticks(1.125)), ticks(1.125));
  length.limit(ticks(0.25));
  EXPECT_EQ(length.end(ticks(1), ticks(2)), ticks(1.25));
}

TEST(WindowLength, GrowsWhereWindowsAreCheapAndShrinksWhereTheyAreDear) {
  Length length = measured();
  const FixedTime usual = next(length);
  length.learn({1, 0}, 100);
  const FixedTime longer = next(length);
  EXPECT_NEAR(static_cast<double>(longer) / static_cast<double>(usual), 1.15, 1e-9);
  length.learn({5, 0}, 100);  // passes
  EXPECT_NEAR(static_cast<double>(next(length)) / static_cast<double>(longer), 0.7, 1e-9);
  length = measured();
  (void)next(length);
  length.learn({1, 124}, 100);  // 60 of 100 and 64
  EXPECT_NEAR(static_cast<double>(next(length)) / static_cast<double>(usual), 1.15, 1e-9);
  length = measured();
  (void)next(length);
  length.learn({1, 125}, 100);  // more than that
  EXPECT_NEAR(static_cast<double>(next(length)) / static_cast<double>(usual), 0.7, 1e-9);
}

TEST(WindowLength, AShortWindowThatIsCheapSaysNothing) {
  Length length = measured();
  const FixedTime usual = next(length);
  (void)length.end(0, usual / 2);
  length.learn({1, 0}, 100);
  EXPECT_EQ(next(length), usual);
}

TEST(WindowLength, StaysWithin32TimesTheUsualOne) {
  Length length = measured();
  const auto usual = static_cast<double>(next(length));
  for (int k = 0; k < 100; ++k) {
    length.learn({1, 0}, 100);
    (void)next(length);
  }
  EXPECT_NEAR(static_cast<double>(next(length)) / usual, 32, 1e-9);
  for (int k = 0; k < 100; ++k) length.learn({5, 0}, 100);
  EXPECT_NEAR(static_cast<double>(next(length)) * 32 / usual, 1, 1e-9);
}

TEST(WindowLength, WhereNothingMovesItIsAsLongAsAFlightMayBe) {
  Box box;
  Length length;
  length.measure(Spacing(16, 0, 8, Domain(box, true), {0, 0}), FixedTimeClock::of_tick(kTick));
  length.start_over();
  EXPECT_EQ(next(length), kLongestFlight / 64);
}

TEST(WindowLength, IsShortenedForTheNextWindow) {
  Length length = measured();
  length.shorten_to(ticks(3));
  EXPECT_NEAR(static_cast<double>(next(length)), static_cast<double>(ticks(0.4)), 1);
  length.shorten_to(ticks(0.125));
  EXPECT_EQ(next(length), ticks(0.125));
}

}  // namespace
}  // namespace carom::event::window_length_test
