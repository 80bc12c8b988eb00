#include "solvers/event/crossing_time.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace carom::event::crossing_time_test {
namespace {

Domain square(double side) {
  Box box;
  box.width = side;
  box.height = side;
  return {box, true};
}

// A box of 3 by 3.
TEST(CrossingTime, IsOfTheFastestBall) {
  std::vector<Ball> balls(2);
  balls[0].velocity = {3, 4};
  balls[1].velocity = {-1, 0};
  balls[1].mass = 1e6;  // with the energy shared, the light one goes much faster
  EXPECT_LT(crossing_time(square(3), {}, balls), 3.0 / 5 / 100);
  balls.pop_back();
  // Alone it has all the energy already; room is left for four times its speed.
  EXPECT_DOUBLE_EQ(crossing_time(square(3), {}, balls), 3.0 / (4 * 5 / std::sqrt(2)));
}

TEST(CrossingTime, OfWhatOnlyFallsIsThatOfTheFall) {
  Effects effects;
  effects.gravity = Gravity{{0, -9}};
  std::vector<Ball> balls(1);
  EXPECT_DOUBLE_EQ(crossing_time(square(4), effects, balls), 4.0 / 6);  // sqrt(9 * 4) = 6
  EXPECT_EQ(gravity_of(effects), (std::array<double, 2>{0, -9}));
}

TEST(CrossingTime, IsOneWhereNothingMoves) {
  std::vector<Ball> balls(1);
  balls[0].velocity = {5, 0};
  balls[0].fixed = true;
  EXPECT_EQ(crossing_time(square(3), {}, balls), 1);
  EXPECT_EQ(crossing_time(square(3), {}, {}), 1);
  EXPECT_EQ(gravity_of({}), (std::array<double, 2>{0, 0}));
}

}  // namespace
}  // namespace carom::event::crossing_time_test
