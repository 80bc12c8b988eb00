#include "fill/equal_disks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>
#include <vector>

#include "support/scenes.hpp"

namespace carom::scene::equal_disks_test {
namespace {

double distance(const Box& box, const Vec2& a, const Vec2& b) {
  Vec2 way = b - a;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (box.periodic[axis]) way[axis] = std::remainder(way[axis], box.size()[axis]);
  }
  return way.norm();
}

// Against all pairs: in a box, round its axes, in a part of it, and in one so narrow that a disk
// meets another both ways round.
TEST(EqualDisks, LeaveRoomWhereNoOtherIsAsNearAsTwoRadii) {
  for (const auto& [width, around_x, around_y, lower, upper] :
       {std::tuple{30.0, false, false, Vec2{0.5, 0.5}, Vec2{29.5, 19.5}},
        std::tuple{30.0, true, true, Vec2{0, 0}, Vec2{30, 20}},
        std::tuple{30.0, true, false, Vec2{0, 3}, Vec2{30, 9}},
        std::tuple{2.5, true, true, Vec2{0, 0}, Vec2{2.5, 20}}}) {
    Box box;
    box.width = width;
    box.height = 20;
    box.periodic = {around_x, around_y};
    const Region centres{lower, upper, {around_x, around_y}};
    EqualDisks disks(box, centres, 0.5, 300);
    std::vector<Vec2> places;
    std::mt19937_64 engine(5);
    std::size_t refused = 0;
    for (int k = 0; k < 3000; ++k) {
      const Vec2 place{lower.x() + (upper.x() - lower.x()) * test::uniform(engine),
                       lower.y() + (upper.y() - lower.y()) * test::uniform(engine)};
      bool free = true;
      for (const Vec2& other : places) free = free && distance(box, place, other) >= 1;
      ASSERT_EQ(disks.is_free(place), free) << width << ' ' << k;
      if (!free) {
        ++refused;
        continue;
      }
      disks.insert(place);
      places.push_back(place);
    }
    EXPECT_GT(refused, 1000U);
    EXPECT_GT(places.size(), 20U);
  }
}

TEST(EqualDisks, MayTouch) {
  Box box;
  box.width = box.height = 40;
  EqualDisks disks(box, {{0.1, 0.1}, {39.9, 39.9}, {}}, 0.1, 100);
  disks.insert({0.3, 0.7});
  EXPECT_TRUE(disks.is_free({0.3 + 0.2, 0.7}));  // in decimals
  EXPECT_FALSE(disks.is_free({0.3 + 0.2 - 1e-12, 0.7}));
}

}  // namespace
}  // namespace carom::scene::equal_disks_test
