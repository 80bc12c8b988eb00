#include "effects/attraction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "state/balls.hpp"
#include "support/random_numbers.hpp"

namespace carom::attraction_test {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;

struct Pull {
  double x;
  double y;
};

std::vector<Ball> scattered(std::size_t count, unsigned seed) {
  test::RandomNumbers random(seed);
  std::vector<Ball> balls(count);
  for (Ball& ball : balls) {
    ball.position = {random.between(-8, 8), random.between(-8, 8)};
    ball.radius = 1e-3;
    ball.mass = std::exp(random.between(-12, 12));
  }
  return balls;
}

std::vector<Pull> pulls(const std::vector<Ball>& scene, const Attraction& attraction) {
  Effects effects;
  effects.attraction = attraction;
  Balls balls(scene, effects);
  Box box;
  box.width = 20;
  box.height = 20;
  box.origin = Box::Origin::center;
  effects::attract(balls, Domain(box, false), attraction, 0, balls.size());
  std::vector<Pull> result(scene.size());
  for (std::size_t i = 0; i < scene.size(); ++i) {
    result[i] = {balls.pull[0][i], balls.pull[1][i]};
  }
  return result;
}

TEST(Attraction, HasTheSameBitsForAnyOrderOfTheBalls) {
  const Attraction attraction{1.5, 0.25};
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<Ball> balls = scattered(61, seed);
    std::vector<std::size_t> order(balls.size());
    std::iota(order.begin(), order.end(), 0U);
    test::RandomNumbers random(seed + 1000);
    for (std::size_t k = order.size(); k > 1; --k) {
      std::swap(order[k - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(k)))]);
    }
    std::vector<Ball> reordered;
    for (const std::size_t i : order) reordered.push_back(balls[i]);

    const std::vector<Pull> expected = pulls(balls, attraction);
    const std::vector<Pull> found = pulls(reordered, attraction);
    for (std::size_t k = 0; k < order.size(); ++k) {
      EXPECT_EQ(found[k].x, expected[order[k]].x) << "seed " << seed << ", ball " << order[k];
      EXPECT_EQ(found[k].y, expected[order[k]].y) << "seed " << seed << ", ball " << order[k];
    }
  }
}

TEST(Attraction, IsTheSumOfThePullsOfAllOthers) {
  const Attraction attraction{1.5, 0.25};
  const std::vector<Ball> balls = scattered(200, 7);
  const std::vector<Pull> found = pulls(balls, attraction);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    Exact x = 0;
    Exact y = 0;
    double largest = 0;
    for (std::size_t j = 0; j < balls.size(); ++j) {
      if (j == i) continue;
      const Exact dx = Exact(balls[j].position[0]) - balls[i].position[0];
      const Exact dy = Exact(balls[j].position[1]) - balls[i].position[1];
      const Exact square = dx * dx + dy * dy + Exact(0.0625);
      const Exact pull = 1.5 * balls[j].mass / (square * sqrt(square));
      x += pull * dx;
      y += pull * dy;
      largest = std::max({largest, std::abs(static_cast<double>(pull * dx)),
                          std::abs(static_cast<double>(pull * dy))});
    }
    // Each term is rounded some eight times.
    EXPECT_NEAR(found[i].x, static_cast<double>(x), 8 * 0x1p-53 * 4 * largest) << i;
    EXPECT_NEAR(found[i].y, static_cast<double>(y), 8 * 0x1p-53 * 4 * largest) << i;
  }
}

TEST(Attraction, OfOneBallIsNothing) {
  const std::vector<Pull> found = pulls(scattered(1, 3), {1.5, 0});
  EXPECT_EQ(found[0].x, 0);
  EXPECT_EQ(found[0].y, 0);
}

}  // namespace
}  // namespace carom::attraction_test
