#include "solvers/event/domains/window_span.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace carom::event::window_span_test {
namespace {

constexpr FixedTime kFar = FixedTime{1} << 60;

const FixedTimeClock kClock(64);  // a window lasts 64 s at most

WindowSpan span_of(const WindowSpan::Gas& gas, bool alone, FixedTime longest = kFar) {
  WindowSpan span(kClock);
  span.set_alone(alone);
  span.begin(gas, longest);
  return span;
}

double seconds(const WindowSpan& span) {
  return kClock.seconds(span.length());
}

// 2 sqrt(pi) n sigma g sqrt(kT / m), with g = (1 - 7 phi / 16) / (1 - phi)^2 at contact and
// kT / m half of the mean square of the speed; it needs to be only about right.
TEST(WindowSpan, TheRateOfCollisionsIsAboutThatOfEnskog) {
  for (const double packing : {0.01, 0.3, 0.6}) {
    const double diameter = 0.2;
    const double spacing = std::sqrt(M_PI * diameter * diameter / 4 / packing);
    const double enskog = 2 * std::sqrt(M_PI) * diameter / (spacing * spacing) *
                          (1 - 7 * packing / 16) / ((1 - packing) * (1 - packing)) *
                          std::sqrt(9.0 / 2);
    EXPECT_NEAR(collision_rate(3, diameter, spacing, packing) / enskog, 1.1, 0.15) << packing;
  }
}

TEST(WindowSpan, BeginsWithTheTimeOfSomeCollisions) {
  const WindowSpan::Gas gas{100, 1, 64, 0, 0, 0};
  EXPECT_NEAR(seconds(span_of(gas, false)), WindowSpan::kCollisions / 64, 1e-9);
  EXPECT_NEAR(seconds(span_of(gas, true)), WindowSpan::kCollisionsAlone / 64, 1e-9);
  EXPECT_EQ(span_of(gas, true, 1000).length(), 1000);
}

// Of several domains no ball goes farther than 1.4 spacings; gravity makes it faster.
TEST(WindowSpan, IsNoLongerThanHalosAreWide) {
  const WindowSpan::Gas gas{100, 3, 1, 30, 0, 0};
  EXPECT_NEAR(seconds(span_of(gas, false)), WindowSpan::kFarthest * 3 / 30, 1e-9);
  EXPECT_NEAR(seconds(span_of(gas, true)), 8, 1e-9);
  WindowSpan falling = span_of({100, 3, 1, 30, 100, 0}, false);
  EXPECT_NEAR(seconds(falling), WindowSpan::kFarthest * 3 / (30 + 100 * 2), 1e-9);
  falling.note_farthest(60, kClock.ticks(2));
  EXPECT_NEAR(falling.farthest(kClock.ticks(0.25)), 30 * 0.25, 1e-9);
}

TEST(WindowSpan, IsShortWhereDragIsStrong) {
  EXPECT_NEAR(seconds(span_of({100, 1, 1, 0, 0, 4}, true)), 0.1 / 4, 1e-9);
}

TEST(WindowSpan, EndsAtTheTargetUnlessOneDomainMayLookBeyond) {
  const WindowSpan::Gas gas{100, 1, 64, 0, 0, 0};
  for (const bool alone : {false, true}) {
    WindowSpan span = span_of(gas, alone);
    const FixedTime length = span.length();
    EXPECT_EQ(span.end(5, 5 + 3 * length), 5 + length);
    EXPECT_EQ(span.end(5, 5 + length / 3), alone ? 5 + length : 5 + length / 3);
  }
}

// With twice the collisions wanted the next is three quarters as long; where the target has cut it
// short, that tells less.
TEST(WindowSpan, LearnsFromTheCollisionsOfTheLast) {
  const WindowSpan::Gas gas{100, 1, 64, 0, 0, 0};
  WindowSpan span = span_of(gas, false);
  const FixedTime length = span.length();
  EXPECT_EQ(span.end(0, 10 * length), length);
  span.learn(2 * 100 * WindowSpan::kCollisions, length);
  EXPECT_NEAR(static_cast<double>(span.length()) / static_cast<double>(length), 0.75, 1e-6);

  WindowSpan cut = span_of(gas, false);
  EXPECT_EQ(cut.end(0, length / 2), length / 2);
  cut.learn(2 * 100 * WindowSpan::kCollisions, length / 2);  // wants a quarter, half at most
  EXPECT_NEAR(static_cast<double>(cut.length()) / static_cast<double>(length), 0.95, 1e-6);
}

TEST(WindowSpan, IsLongerWhereADomainIsAlone) {
  WindowSpan span = span_of({100, 1, 64, 0, 0, 0}, true);
  const double alone = seconds(span);
  span.set_alone(false);
  EXPECT_NEAR(seconds(span), alone / 4, 1e-9);
  EXPECT_EQ(span.collisions(), WindowSpan::kCollisions);
}

}  // namespace
}  // namespace carom::event::window_span_test
