#include "solvers/event/islands/open_axes.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "contact/contact_graph.hpp"

namespace carom::event::open_axes_test {
namespace {

/// Two balls beside each other on a floor, with what friction it has.
IslandMotion pair_on_floor(double friction) {
  IslandMotion island;
  island.bodies.resize(2, {{0, 0}, 0, 1});
  island.contacts = {
      {0, kWall, {0, -1}, 0, friction}, {1, kWall, {0, -1}, 0, friction}, {0, 1, {1, 0}, 0, 0.5}};
  return island;
}

TEST(OpenAxes, AreThoseAlongSmoothWalls) {
  EXPECT_TRUE(open_axes(pair_on_floor(0)).x);
  EXPECT_FALSE(open_axes(pair_on_floor(0)).y);
  EXPECT_FALSE(open_axes(pair_on_floor(0.1)).x);
  IslandMotion on_fixed_ball = pair_on_floor(0);
  on_fixed_ball.contacts.push_back({1, kWall, {0.6, -0.8}, 0, 0});
  EXPECT_FALSE(open_axes(on_fixed_ball).x);
}

TEST(OpenAxes, HaveBothBallsInTheAir) {
  EXPECT_TRUE(open_axes({}).x && open_axes({}).y);
}

// However little it is beyond rounding, as that of the cosine of a right angle.
TEST(OpenAxes, NothingHoldsWhatIsPulledAlongThem) {
  const IslandMotion pair = pair_on_floor(0);
  EXPECT_EQ(pulled_along(pair, {1e-15, -1}, {1, 1, 1}), (std::vector<char>{1, 1}));
  EXPECT_EQ(pulled_along(pair, {7e-17, -1}, {1, 1, 1}), (std::vector<char>{0, 0}));
  EXPECT_EQ(pulled_along(pair, {0, -1}, {1, 1, 1}), (std::vector<char>{0, 0}));
  EXPECT_EQ(pulled_along(pair_on_floor(0.1), {1, -1}, {1, 1, 1}), (std::vector<char>{0, 0}));
}

// A wall holds what touches it, and what that touches.
TEST(OpenAxes, AWallHoldsAllThatTouches) {
  IslandMotion pair = pair_on_floor(0);
  pair.contacts.push_back({1, kWall, {1, 0}, 0, 0});
  EXPECT_EQ(pulled_along(pair, {1, -1}, {1, 1, 1, 1}), (std::vector<char>{0, 0}));
  EXPECT_EQ(pulled_along(pair, {1, -1}, {1, 1, 0, 1}), (std::vector<char>{1, 0}));
}

}  // namespace
}  // namespace carom::event::open_axes_test
