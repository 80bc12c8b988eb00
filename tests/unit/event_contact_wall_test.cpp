#include <gtest/gtest.h>

#include <algorithm>

#include "contact/pair_impact.hpp"
#include "support/exact_number.hpp"
#include "support/random_numbers.hpp"
#include "trajectory/wall_time.hpp"

namespace carom::event::event_contact_wall_test {
namespace {

using test::error_in_u;
using test::Exact;
using test::RandomNumbers;

constexpr double kNever = std::numeric_limits<double>::infinity();

TEST(EventWallTime, InFreeFlightIsTheDistanceOverTheSpeed) {
  EXPECT_EQ(wall_time(3.0, -2.0), 1.5);
  EXPECT_EQ(wall_time(3.0, 2.0), kNever);
  EXPECT_EQ(wall_time(3.0, 0.0), kNever);
}

TEST(EventWallTime, OfABallLeavingTheWallAtTheWallIsNotNow) {
  EXPECT_EQ(wall_time(0.0, 1.0), kNever);
  EXPECT_EQ(wall_time(0.0, -1.0), 0);
  EXPECT_EQ(wall_time(0.0, 1.0, 0.0), kNever);
  EXPECT_EQ(wall_time(0.0, 1.0, 2.0), kNever);
  EXPECT_EQ(wall_time(0.0, 3.0, -2.0), 3.0);
}

TEST(EventWallTime, OfAHopIsTwiceTheSpeedOverTheAcceleration) {
  RandomNumbers random(1);
  for (int k = 0; k < 1000; ++k) {
    const double v = std::exp(random.between(-80, 10));
    EXPECT_EQ(wall_time(0.0, v, -9.81), 2 * v / 9.81);
    EXPECT_EQ(wall_arrival_velocity(0.0, v, -9.81), -v);
  }
}

TEST(EventWallTime, FindsTheSecondRootThrownUpFromAboveTheWall) {
  EXPECT_EQ(wall_time(0.0, 4.0, -8.0), 1);
  EXPECT_EQ(wall_time(1.0, 0.0, -2.0), 1);
  EXPECT_EQ(wall_time(3.0, 1.0, -8.0), 1);   // 3 + t - 4 t^2
  EXPECT_EQ(wall_time(3.0, -1.0, -4.0), 1);  // 3 - t - 2 t^2
}

TEST(EventWallTime, MissesAWallThatPushesAwayUnlessFastEnough) {
  EXPECT_EQ(wall_time(1.0, -2.0, 2.0), kNever);  // touches at its turning point, without speed
  EXPECT_EQ(wall_time(1.0, -1.9, 2.0), kNever);
  EXPECT_EQ(wall_time(3.0, -4.0, 2.0), 1);
  EXPECT_EQ(wall_time(1.0, 2.0, 2.0), kNever);
}

TEST(EventWallTime, BeyondTheWallIsNowComingAndLaterGoing) {
  EXPECT_EQ(wall_time(-1.0, -1.0), 0);
  EXPECT_EQ(wall_time(-1.0, 1.0), kNever);
  EXPECT_EQ(wall_time(-1.0, -1.0, -1.0), 0);
  EXPECT_EQ(wall_time(-1.5, 2.0, -1.0), 3);  // out at 1, back at 3
  EXPECT_EQ(wall_time(-8.0, 2.0, -1.0), 2);  // turns round inside
  EXPECT_EQ(wall_time(-1.0, 0.0, -1.0), 0);
  EXPECT_EQ(wall_time(-1.0, 0.0, 1.0), kNever);
}

TEST(EventWallTime, IsRightToFourUnitsAndItsArrivalKeepsTheEnergy) {
  RandomNumbers random(2);
  double worst = 0;
  double worst_arrival = 0;
  for (int k = 0; k < 20000; ++k) {
    const double h = std::exp(random.between(-20, 5));
    const double v = random.sign() * std::exp(random.between(-10, 5));
    const double a = -std::exp(random.between(-10, 5));
    const Exact d = Exact(v) * v - 2 * Exact(a) * h;
    const Exact truth = (Exact(v) + sqrt(d)) / -Exact(a);
    worst = std::max(worst, error_in_u(wall_time(h, v, a), truth));
    worst_arrival = std::max(worst_arrival, error_in_u(wall_arrival_velocity(h, v, a), -sqrt(d)));
  }
  EXPECT_GT(worst, 0);
  EXPECT_LE(worst, 4);
  EXPECT_LE(worst_arrival, 2);
}

TEST(EventWallTime, ABallDroppedKeepsItsEnergyToTheLastBitForEver) {
  double v = 1;
  for (int k = 0; k < 100000; ++k) {
    v = wall_impact(wall_arrival_velocity(0.0, v, -9.81), 1.0);
  }
  EXPECT_EQ(v, 1);
}

TEST(EventWallTime, HeightsFallByTheSquareOfTheRestitution) {
  const double e = 0.8;
  const double g = 9.81;
  double v = wall_impact(wall_arrival_velocity(1.0, 0.0, -g), e);
  Exact height = 1;
  for (int n = 1; n <= 150; ++n) {
    height *= Exact(e) * e;
    EXPECT_LE(abs(Exact(v) * v / (2 * Exact(g)) / height - 1), 1e-12) << n;
    v = wall_impact(wall_arrival_velocity(0.0, v, -g), e);
  }
}

}  // namespace
}  // namespace carom::event::event_contact_wall_test
