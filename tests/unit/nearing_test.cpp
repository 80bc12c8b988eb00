#include "solvers/event/nearing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/flight_at.hpp"

namespace carom::event::nearing_test {
namespace {

Motion<Ballistic> motion() {
  Box box;
  box.width = 10;
  box.height = 10;
  box.origin = Box::Origin::center;
  return Motion<Ballistic>(Rules{{box, true}, FixedTimeClock(0.5)});
}

TEST(Nearing, OfAWallIsWhatGoesTowardsIt) {
  const Motion<Ballistic> flights = motion();
  const Disk up_right = flight_at(0, 0, 1, 2);
  EXPECT_FALSE(nears_wall(flights, up_right, kWalls, 0));     // left
  EXPECT_TRUE(nears_wall(flights, up_right, kWalls + 1, 0));  // right
  EXPECT_FALSE(nears_wall(flights, up_right, kWalls + 2, 0));
  EXPECT_TRUE(nears_wall(flights, up_right, kWalls + 3, 0));
}

TEST(Nearing, IsNoRoundingOfTheSpeed) {
  const Motion<Ballistic> flights = motion();
  EXPECT_FALSE(nears_wall(flights, flight_at(0, 0, 0x1p-48, 1), kWalls + 1, 0));
  EXPECT_TRUE(nears_wall(flights, flight_at(0, 0, 0x1p-44, 1), kWalls + 1, 0));
  EXPECT_FALSE(nears_ball(flights, flight_at(0, 0, 0x1p-48, 1), flight_at(1, 0, 0, 1), 0));
  EXPECT_TRUE(nears_ball(flights, flight_at(0, 0, 0x1p-44, 1), flight_at(1, 0, 0, 1), 0));
  EXPECT_FALSE(nears_wall(flights, flight_at(0, 0, 0, 0), kWalls, 0));
}

// Two around a circle: they approach where their relative velocity points inwards.
TEST(Nearing, OfTwoBallsIsSeenFromEither) {
  const Motion<Ballistic> flights = motion();
  for (int k = 0; k < 12; ++k) {
    const double angle = 0.3 + k;
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    for (const double speed : {-0.5, 0.5}) {
      const Disk still = flight_at(0, 0, 3, 4);
      const Disk other = flight_at(x, y, 3 - speed * x - 2 * y, 4 - speed * y + 2 * x);
      EXPECT_EQ(nears_ball(flights, still, other, 0), speed > 0) << k;
      EXPECT_EQ(nears_ball(flights, other, still, 0), speed > 0) << k;
    }
  }
}

}  // namespace
}  // namespace carom::event::nearing_test
