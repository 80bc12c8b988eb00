// The search that looks at near balls only, held against one that looks at all pairs.
#include <gtest/gtest.h>

#include <cmath>

#include "fill/disk_grid.hpp"
#include "fill/overlap_search.hpp"
#include "support/random_numbers.hpp"

namespace carom::overlap_search_test {
namespace {

bool overlap_of_all_pairs(const Box& box, const std::vector<Ball>& balls) {
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (balls[i].fixed && balls[j].fixed) continue;
      if (scene::overlap_depth(box, balls[i].position, balls[i].radius, balls[j].position,
                               balls[j].radius) > 0) {
        return true;
      }
    }
  }
  return false;
}

TEST(OverlapSearch, SaysWhatAllPairsSay) {
  int overlapping = 0;
  int apart = 0;
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    test::RandomNumbers random(seed);
    Box box;
    box.width = random.between(1, 40);
    box.height = random.between(1, 40);
    for (bool& periodic : box.periodic) periodic = random.below(2) == 0;
    if (random.below(2) == 0) box.origin = Box::Origin::center;
    const bool touching = random.below(4) == 0;  // a lattice whose disks just touch
    const double radius = touching ? 0.5 : random.between(0.01, 0.4);
    std::vector<Ball> balls(static_cast<std::size_t>(2 + random.below(30)));
    for (Ball& ball : balls) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        ball.position[axis] = random.between(box.lower()[axis], box.upper()[axis]);
        if (touching) ball.position[axis] = std::floor(ball.position[axis]) + 0.5;
      }
      ball.radius = touching ? radius : radius * random.between(0.2, 1);
      ball.fixed = random.below(4) == 0;
    }
    // In half of the scenes all are far apart, but for two that may just meet, in any direction.
    if (!touching && seed % 2 == 0) {
      balls.resize(4);
      for (std::size_t i = 0; i < 3; ++i)
        balls[i].position = box.lower() + static_cast<double>(i) / 3 * box.size();
      const double angle = random.angle();
      const double way = (balls[1].radius + balls[3].radius) * random.between(0.9, 1.1);
      balls[3].position = balls[1].position + way * Vec2{std::cos(angle), std::sin(angle)};
    }
    const bool expected = overlap_of_all_pairs(box, balls);
    (expected ? overlapping : apart) += 1;
    ASSERT_EQ(scene::may_overlap(box, balls), expected) << "seed " << seed;
  }
  EXPECT_GT(overlapping, 400);
  EXPECT_GT(apart, 400);
}

}  // namespace
}  // namespace carom::overlap_search_test
