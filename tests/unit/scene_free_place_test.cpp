#include <gtest/gtest.h>

#include "carom/free_place.hpp"
#include "carom/scene_file.hpp"

namespace carom::scene_free_place_test {
namespace {

Scene in_island() {
  return parse_scene(
      R"({"box": {"width": 8, "height": 6}, "effects": {"walls": {}, "collisions": {}},
          "fill": [{"count": 48, "arrangement": "square"}]})",
      "crowded");
}

TEST(FreePlace, IsFreeAndInsideAndFollowsFromItsNumber) {
  Scene scene = builtin_scene();
  for (std::uint64_t number = 0; number < 20; ++number) {
    const auto place = find_free_place(scene, scene.balls, 0.3, number);
    ASSERT_TRUE(place);
    EXPECT_EQ(*place, *find_free_place(scene, scene.balls, 0.3, number));
    Ball ball;
    ball.position = *place;
    ball.radius = 0.3;
    scene.balls.push_back(ball);
    EXPECT_TRUE(find_problems(scene).empty());
  }
}

TEST(FreePlace, IsFoundWhereOnlyOneIsLeft) {
  Scene scene = in_island();
  std::vector<Ball> balls = populate(scene);
  EXPECT_FALSE(find_free_place(scene, balls, 0.5, 1));
  const Vec2 gap = balls[27].position;
  balls.erase(balls.begin() + 27);
  const auto place = find_free_place(scene, balls, 0.48, 1);
  ASSERT_TRUE(place);
  EXPECT_LT((*place - gap).norm(), 0.05);
}

TEST(FreePlace, IsNotThereForABallLargerThanTheBox) {
  EXPECT_FALSE(find_free_place(in_island(), {}, 3.5, 1));
}

}  // namespace
}  // namespace carom::scene_free_place_test
