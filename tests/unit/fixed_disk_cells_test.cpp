#include "solvers/event/fixed_disk_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "support/scenes.hpp"

namespace carom::event::fixed_disk_cells_test {
namespace {

using test::box_of;

bool touch(const Box& box, const Ball& a, const Ball& b) {
  Vec2 way = b.position - a.position;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (box.periodic[axis]) way[axis] = std::remainder(way[axis], box.size()[axis]);
  }
  return way.norm() <= a.radius + b.radius;
}

// Against all pairs: balls and fixed ones from tiny ones to some as large as the box, beyond its
// ends, too.
TEST(FixedDiskCells, FindAllThatTouch) {
  std::mt19937_64 engine(11);
  for (const Box& box : {box_of(30, 20, false, false), box_of(30, 20, true, false),
                         box_of(20, 30, true, true), box_of(1000, 1, true, true)}) {
    std::vector<Ball> balls;
    for (int k = 0; k < 600; ++k) {
      Ball ball;
      ball.position = {box.width * (1.2 * test::uniform(engine) - 0.1),
                       box.height * (1.2 * test::uniform(engine) - 0.1)};
      ball.radius = 0.01 * std::pow(2000.0, std::pow(test::uniform(engine), 4));
      ball.fixed = k % 3 == 0;
      balls.push_back(ball);
    }
    const FixedDiskCells cells(Domain(box, true), balls);
    std::size_t touching = 0;
    for (const Ball& ball : balls) {
      std::size_t expected = 0;
      for (const Ball& other : balls) expected += other.fixed && touch(box, ball, other) ? 1 : 0;
      std::vector<const Ball*> found;
      (void)cells.any_near(ball, [&](const Ball& other) {
        EXPECT_TRUE(other.fixed);
        const bool seen = std::find(found.begin(), found.end(), &other) != found.end();
        if (!seen && touch(box, ball, other)) found.push_back(&other);
        return false;
      });
      EXPECT_EQ(found.size(), expected);
      EXPECT_EQ(cells.any_near(ball, [&](const Ball& other) { return touch(box, ball, other); }),
                expected > 0);
      touching += expected;
    }
    EXPECT_GT(touching, 200U);
  }
}

// Of ten thousand few are looked at.
TEST(FixedDiskCells, AskFewOfMany) {
  const Box box = box_of(100, 100, true, true);
  std::mt19937_64 engine(12);
  std::vector<Ball> balls(20000);
  for (std::size_t k = 0; k < balls.size(); ++k) {
    balls[k].position = {100 * test::uniform(engine), 100 * test::uniform(engine)};
    balls[k].radius = k == 0 ? 40 : 0.2;
    balls[k].fixed = k % 2 == 0;
  }
  const FixedDiskCells cells(Domain(box, true), balls);
  std::size_t asked = 0;
  for (const Ball& ball : balls) {
    if (ball.fixed) continue;
    (void)cells.any_near(ball, [&](const Ball&) {
      ++asked;
      return false;
    });
  }
  EXPECT_GT(asked, 1000U);
  EXPECT_LT(asked, 20U * balls.size());
}

TEST(FixedDiskCells, AreNoneWhereNothingIsFixed) {
  const std::vector<Ball> balls(5);
  const FixedDiskCells cells(Domain(box_of(9, 9, false, false), true), balls);
  EXPECT_FALSE(cells.any_near(balls.front(), [](const Ball&) { return true; }));
}

}  // namespace
}  // namespace carom::event::fixed_disk_cells_test
