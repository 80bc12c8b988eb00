#include <gtest/gtest.h>

#include <cmath>

#include "effects/drag.hpp"
#include "effects/gravity.hpp"
#include "effects/walls.hpp"

namespace carom::flight_test {
namespace {

struct Outcome {
  double position;
  double velocity;
  std::uint64_t impacts;
};

// One ball of radius 1/2 along the x axis of a box [0, 10], one step.
Outcome fly(double position, double velocity, double acceleration, double step,
            double restitution) {
  Ball ball;
  ball.position.x() = position;
  ball.velocity.x() = velocity;
  const Balls balls({ball});
  Box box;
  box.width = 10;
  const Domain domain(box, true);
  Flight flight;
  prepare(flight, balls, 0, 0, 1, step, effects::fall(acceleration, step));
  straight(flight);
  if (acceleration != 0) effects::gravity(flight);
  land(flight);
  const effects::WallRule rule{restitution, acceleration};
  const std::uint64_t impacts = effects::walls(flight, domain, rule);
  return {flight.moved[0], flight.after[0], impacts};
}

TEST(Flight, IsAnExactParabola) {
  const Outcome outcome = fly(5, 2, -8, 0.25, 1);
  EXPECT_EQ(outcome.position, 5 + 2 * 0.25 - 8 * 0.25 * 0.25 / 2);
  EXPECT_EQ(outcome.velocity, 0);
}

TEST(Walls, ReflectAtAnySpeedAndPutTheBallOnTheWall) {
  for (const double speed : {100.0, 1e8, 1e200}) {
    const Outcome outcome = fly(5, speed, 0, 0.25, 0.5);
    EXPECT_EQ(outcome.position, 9.5);
    EXPECT_EQ(outcome.velocity, -0.5 * speed);
    EXPECT_EQ(outcome.impacts, 1U);
  }
}

TEST(Walls, AreMetWithTheSpeedThatEnergyGivesThere) {
  // From 1 above the floor, at rest: sqrt(2 g h) at the floor.
  const Outcome outcome = fly(1.5, 0, -9.81, 1, 1);
  EXPECT_EQ(outcome.position, 0.5);
  EXPECT_NEAR(outcome.velocity, std::sqrt(2 * 9.81), 1e-15);
}

TEST(Walls, GiveBackTheSmallestHopWhereNothingIsLost) {
  const double bounce = 1e-3;
  const Outcome outcome = fly(0.5, bounce, -9.81, 1.0 / 240, 1);
  EXPECT_EQ(outcome.velocity, bounce);
  EXPECT_EQ(outcome.impacts, 1U);
}

TEST(Domain, WrapsAnyDistanceAndMirrorsToTheBit) {
  Box box;
  box.width = 10;
  box.origin = Box::Origin::center;
  box.periodic = {true, false};
  const Domain domain(box, true);
  EXPECT_EQ(domain.wrapped(0, 5.25), -4.75);
  EXPECT_EQ(domain.wrapped(0, 123.5), 3.5);
  for (const double x : {4.9, 5.1, 77.77, 1e9 + 0.3, 1e300}) {
    EXPECT_EQ(domain.wrapped(0, -x), -domain.wrapped(0, x));
    EXPECT_LE(std::abs(domain.wrapped(0, x)), 5);
  }
  EXPECT_TRUE(domain.solid(1));
}

}  // namespace
}  // namespace carom::flight_test
