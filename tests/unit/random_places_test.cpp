#include "fill/random_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/scenes.hpp"

namespace carom::scene::random_places_test {
namespace {

using test::box_of;

struct Case {
  const char* name;
  Box box;
  Region region;
  double radius;
  std::size_t count;
  std::vector<Ball> before;
  std::size_t tries;
};

Ball ball_at(double x, double y, double radius) {
  Ball ball;
  ball.position = {x, y};
  ball.radius = radius;
  return ball;
}

DiskGrid grid_of(const Case& c) {
  DiskGrid grid(c.box);
  for (const Ball& ball : c.before) grid.insert(ball.position, ball.radius);
  return grid;
}

/// One draw, one test, one after the other.
std::vector<Vec2> drawn_one_by_one(const Case& c) {
  DiskGrid grid = grid_of(c);
  Random random(7, 0);
  std::vector<Vec2> places;
  for (std::size_t k = 0; k < c.tries && places.size() < c.count; ++k) {
    Vec2 place{0, 0};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const bool around = c.region.around[axis];
      const double lower = c.region.lower[axis] + (around ? 0 : c.radius);
      const double upper = std::max(lower, c.region.upper[axis] - (around ? 0 : c.radius));
      place[axis] = std::min(lower + random.uniform() * (upper - lower), upper);
      if (around && place[axis] >= upper) place[axis] = lower;
    }
    if (!grid.is_free(place, c.radius)) continue;
    grid.insert(place, c.radius);
    places.push_back(place);
  }
  return places;
}

TEST(RandomPlaces, AreThoseOfOneDrawAndOneTestAfterTheOther) {
  const std::vector<Case> cases{
      {"few", box_of(20, 10, false, false), {{0, 0}, {20, 10}, {}}, 0.5, 90, {}, 100000},
      {"dense", box_of(60, 60, false, false), {{0, 0}, {60, 60}, {}}, 0.5, 2200, {}, 1000000},
      {"around",
       box_of(60, 50, true, true),
       {{0, 0}, {60, 50}, {true, true}},
       0.5,
       1700,
       {},
       1000000},
      {"part", box_of(90, 50, true, false), {{20, 5}, {75, 45}, {}}, 0.5, 1200, {}, 1000000},
      {"sparse",
       box_of(3000, 3000, true, true),
       {{0, 0}, {3000, 3000}, {true, true}},
       0.5,
       1500,
       {},
       1000000},
      {"narrow",
       box_of(4000, 1.5, true, true),
       {{0, 0}, {4000, 1.5}, {true, true}},
       0.5,
       1500,
       {},
       1000000},
      {"others",
       box_of(60, 50, true, true),
       {{0, 0}, {60, 50}, {true, true}},
       0.3,
       2000,
       {ball_at(1, 1, 4), ball_at(30, 30, 0.05), ball_at(59, 20, 7)},
       1000000},
      {"no room", box_of(40, 40, false, false), {{0, 0}, {40, 40}, {}}, 0.5, 2000, {}, 20011},
      {"far",
       box_of(0x1p40, 0x1p40, false, false),
       {{0x1p39, 0x1p39}, {0x1p39 + 40, 0x1p39 + 40}, {}},
       0.5,
       900,
       {},
       100000}};
  for (const Case& c : cases) {
    const std::vector<Vec2> expected = drawn_one_by_one(c);
    const DiskGrid grid = grid_of(c);
    Random random(7, 0);
    std::vector<Vec2> places;
    RandomPlaces(c.box, c.region, c.radius, c.count, c.before, grid).draw(random, c.tries, places);
    EXPECT_GT(expected.size(), 50U) << c.name;
    ASSERT_EQ(places.size(), expected.size()) << c.name;
    for (std::size_t k = 0; k < places.size(); ++k) ASSERT_EQ(places[k], expected[k]) << c.name;
  }
}

}  // namespace
}  // namespace carom::scene::random_places_test
