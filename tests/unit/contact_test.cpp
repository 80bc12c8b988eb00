#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "contact/cell_grid.hpp"
#include "contact/groups.hpp"
#include "contact/impulse.hpp"
#include "contact/touching.hpp"
#include "support/scenes.hpp"

namespace carom::contact_test {
namespace {

std::vector<Pair> sorted(const PairList& pairs) {
  std::vector<Pair> result;
  for (std::size_t k = 0; k < pairs.count; ++k) {
    result.push_back(
        {static_cast<std::uint32_t>(pairs.first[k]), static_cast<std::uint32_t>(pairs.second[k])});
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(PairList, HoldsEveryUniquePairOnceButNoPairOfFixedBalls) {
  std::vector<Ball> balls(4);
  balls[1].fixed = balls[3].fixed = true;
  const std::vector<Pair> expected{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}};
  EXPECT_EQ(sorted(all_pairs(Balls(balls))), expected);
}

// The grid against trying all pairs, for boxes of few and of many cells, periodic or not, and balls
// beyond open sides.
TEST(CellGrid, FindsExactlyThePairsThatAreNear) {
  std::mt19937_64 engine(3);
  for (const double width : {2.2, 3.1, 4.4, 9.0, 40.0}) {
    for (const int periodic : {0, 1, 2, 3}) {
      Box box;
      box.width = width;
      box.height = 7;
      box.periodic = {(periodic & 1) != 0, (periodic & 2) != 0};
      const Domain domain(box, false);
      std::vector<Ball> list;
      for (int i = 0; i < 60; ++i) {
        Ball ball;
        ball.radius = i % 3 == 0 ? 0.5 : 0.1;
        for (std::size_t k = 0; k < 2; ++k) {
          const double spread = box.periodic[static_cast<std::size_t>(k)] ? 1 : 1.5;
          ball.position[k] = box.size()[k] * (0.5 + spread * (test::uniform(engine) - 0.5));
        }
        list.push_back(ball);
      }
      const Balls balls(list);
      const double skin = 0.1;
      CellGrid grid;
      grid.sort(balls, domain, 1 + skin);
      PairList pairs;
      const std::size_t half = grid.cells() / 2;
      grid.neighbours(domain, 0, half, skin, pairs);
      grid.neighbours(domain, half, grid.cells(), skin, pairs);
      std::vector<Pair> expected;
      for (std::uint32_t i = 0; i < list.size(); ++i) {
        for (std::uint32_t j = i + 1; j < list.size(); ++j) {
          Vec2 r = list[j].position - list[i].position;
          for (std::size_t k = 0; k < 2; ++k) {
            if (box.periodic[static_cast<std::size_t>(k)]) {
              r[k] = std::remainder(r[k], box.size()[k]);
            }
          }
          if (r.norm() < list[i].radius + list[j].radius + skin) expected.push_back({i, j});
        }
      }
      EXPECT_EQ(sorted(pairs), expected) << "width " << width << ", periodic " << periodic;
    }
  }
}

TEST(Touching, TakesDisksThatOverlapAndNotThoseWhoseBoxesDo) {
  std::vector<Ball> balls(4);
  balls[1].position = {0.875, 0};    // overlaps ball 0 by 0.125
  balls[2].position = {-0.8, -0.8};  // its box overlaps that of ball 0
  balls[3].position = {1.875, 0};    // touches ball 1 exactly
  std::vector<Pair> touching;
  const PairList pairs = all_pairs(Balls(balls));
  const double deepest = find_touching(pairs, 0, pairs.count, Balls(balls), {0, 0}, 1, touching);
  EXPECT_EQ(touching, (std::vector<Pair>{{0, 1}}));
  EXPECT_EQ(deepest, 0.25);
}

TEST(Touching, SeesBallsAcrossAPeriodicSide) {
  std::vector<Ball> balls(2);
  balls[0].position = {0.2, 5};
  balls[1].position = {9.5, 5};
  std::vector<Pair> touching;
  const PairList pairs = all_pairs(Balls(balls));
  const double deepest = find_touching(pairs, 0, 1, Balls(balls), {10, 0}, 1, touching);
  EXPECT_EQ(touching.size(), 1U);
  EXPECT_NEAR(deepest, 0.6, 1e-14);
}

TEST(Groups, JoinPairsThatShareABallAndKeepTheirOrder) {
  Groups groups;
  const std::vector<Pair> pairs{{0, 7}, {1, 2}, {2, 5}, {3, 7}, {4, 6}, {5, 8}};
  groups.sort(pairs, 9);
  ASSERT_EQ(groups.count(), 3U);
  const auto group = [&](std::size_t g) {
    return std::vector<Pair>(groups.group(g).begin(), groups.group(g).end());
  };
  EXPECT_EQ(group(0), (std::vector<Pair>{{0, 7}, {3, 7}}));
  EXPECT_EQ(group(1), (std::vector<Pair>{{1, 2}, {2, 5}, {5, 8}}));
  EXPECT_EQ(group(2), (std::vector<Pair>{{4, 6}}));
  EXPECT_EQ(groups.largest(), 3U);
  groups.sort(std::vector<Pair>{{1, 2}}, 9);
  EXPECT_EQ(groups.count(), 1U);
}

// J_n = -(1 + e) (v_j - v_i).n / (1/m_i + 1/m_j), here along an r that is not a unit vector.
TEST(Impulse, IsTheOneOfTheTextbook) {
  const Vec2 r{0.3, -0.4};
  const Vec2 v{-2, 1};
  const Vec2 n = r / 0.5;
  const double inverse_masses = 1 / 2.0 + 1 / 3.0;
  for (const double e : {0.0, 0.3, 1.0}) {
    const double expected = -(1 + e) * v.dot(n) / inverse_masses;
    const Vec2 momentum = impulse(v.dot(r), r.squaredNorm(), inverse_masses, e) * r;
    EXPECT_NEAR((momentum - expected * n).norm(), 0, 1e-15);
  }
}

TEST(LineOfCentres, FollowsTheMotionWhereCentresCoincide) {
  const LineOfCentres line = line_of_centres({0, 0}, {3, 4});
  EXPECT_LT(line.r.dot(Vec2(3, 4)), 0);  // so that the balls approach
  EXPECT_EQ(line.distance, 0);
  EXPECT_EQ(line_of_centres({0, 0}, {0, 0}).r, Vec2(1, 0));
}

TEST(LineOfCentres, KeepsTheDirectionOfTinyDistances) {
  const LineOfCentres line = line_of_centres({3e-300, 4e-300}, {1, 0});
  EXPECT_NEAR(line.r.x() / line.length, 0.6, 1e-15);
  EXPECT_NEAR(line.r.y() / line.length, 0.8, 1e-15);
  EXPECT_NEAR(line.distance / 5e-300, 1, 1e-14);
}

}  // namespace
}  // namespace carom::contact_test
