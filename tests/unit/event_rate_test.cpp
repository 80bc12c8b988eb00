#include "solvers/event/event_rate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace carom::event::event_rate_test {
namespace {

BallsOfBox gas(std::size_t count, double radius, double area, double square_speed) {
  BallsOfBox balls;
  balls.area = area;
  balls.count = count;
  for (std::size_t k = 0; k < count; ++k) balls.add(radius, square_speed);
  return balls;
}

// Kinetic theory: each of n disks of diameter d hits others at 2 d (n / A) sqrt(pi T / m) g, T / m
// half of the mean square of the speed, g the contact value; each impact is shared by two.  The
// guess is for events, of which there are one to eight for an impact.
TEST(EventRate, IsSomeTimesTheImpactRateOfKineticTheory) {
  for (const double packing : {0.05, 0.3, 0.7}) {
    constexpr double kBalls = 4000;
    const double radius = 0.5;
    const double area = kBalls * std::numbers::pi * radius * radius / packing;
    const double square = 2;
    const double contact = (1 - 7 * packing / 16) / ((1 - packing) * (1 - packing));
    const double impacts =
        kBalls * 2 * radius * (kBalls / area) * std::sqrt(std::numbers::pi * square / 2) * contact;
    const double events = guessed_event_rate(gas(4000, radius, area, square));
    EXPECT_GT(events, impacts) << packing;
    EXPECT_LT(events, 8 * impacts) << packing;
  }
}

TEST(EventRate, GoesWithTheSpeed) {
  EXPECT_DOUBLE_EQ(guessed_event_rate(gas(100, 0.5, 1000, 9)),
                   3 * guessed_event_rate(gas(100, 0.5, 1000, 1)));
  EXPECT_EQ(guessed_event_rate(gas(100, 0.5, 1000, 0)), 0);
  BallsOfBox falling = gas(100, 0.5, 1000, 0);
  falling.gravity = 1;
  EXPECT_GT(guessed_event_rate(falling), 0);
}

// A ball alone meets walls, and balls without end in a box that is full are no reason for none.
TEST(EventRate, IsFiniteForAnyNumberOfBalls) {
  EXPECT_EQ(guessed_event_rate(gas(0, 0.5, 1000, 1)), 0);
  EXPECT_DOUBLE_EQ(guessed_event_rate(gas(1, 0, 100, 1)), 4 * 1.0 / 10);
  const double full = guessed_event_rate(gas(2000, 0.5, 1000, 1));
  EXPECT_TRUE(std::isfinite(full));
  EXPECT_GT(full, 0);
}

}  // namespace
}  // namespace carom::event::event_rate_test
