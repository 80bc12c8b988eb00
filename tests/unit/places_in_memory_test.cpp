#include "solvers/event/places_in_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace carom::event::places_in_memory_test {
namespace {

Domain square(double side) {
  Box box;
  box.width = side;
  box.height = side;
  return {box, true};
}

std::vector<Ball> scattered(std::size_t count, double side) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(0, side);
  std::vector<Ball> balls(count);
  for (Ball& ball : balls) ball.position = {uniform(random), uniform(random)};
  return balls;
}

TEST(PlacesInMemory, AreThoseOfTheSceneForFewBalls) {
  const auto balls = scattered(kManyBalls - 1, 100);
  std::vector<Index> wanted(balls.size());
  std::iota(wanted.begin(), wanted.end(), 0U);
  EXPECT_EQ(places_in_memory(square(100), balls), wanted);
}

// Balls that follow each other in memory are nearer than two at random, which are .52 of the side
// apart on average.
TEST(PlacesInMemory, AreOneForEachBallAndNextToItsNeighbours) {
  const auto balls = scattered(2 * kManyBalls, 100);
  const std::vector<Index> place = places_in_memory(square(100), balls);
  std::vector<std::size_t> ball_at(balls.size(), balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i) ball_at.at(place[i]) = i;
  ASSERT_EQ(std::count(ball_at.begin(), ball_at.end(), balls.size()), 0);
  double apart = 0;
  for (std::size_t k = 1; k < ball_at.size(); ++k) {
    apart += (balls[ball_at[k]].position - balls[ball_at[k - 1]].position).norm();
  }
  EXPECT_LT(apart / static_cast<double>(balls.size()), 10);
}

}  // namespace
}  // namespace carom::event::places_in_memory_test
