// The method is compiled for a law of flight and a number; friction, contacts that rest, fixed
// balls and sharing are asked where they matter.  A scene has the same bits whatever else is looked
// for.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "solvers/event/loop_core.hpp"
#include "state/balls.hpp"
#include "support/scenes.hpp"

namespace carom::event::event_instances_test {
namespace {

struct Told {
  bool rests = false;
  bool friction = false;
  bool gravity = false;
  std::size_t parts = 1;
};

std::string hash(const Scene& scene, const Told& told) {
  CoreStart start{Domain(scene.box, has_walls(scene.effects)),
                  scene.effects,
                  scene.balls,
                  {},
                  told.rests,
                  1,
                  {told.parts, 0},
                  ""};
  if (told.friction) start.effects.friction = Friction{};
  if (told.gravity) start.effects.gravity = Gravity{{0, 0}};
  LoopCore<Ballistic> core(std::move(start));
  Crew crew(1, core.phases());
  for (int frame = 1; frame <= 20; ++frame) {
    const std::size_t first = core.aim(0.1 * frame);
    if (first != Phase::kFrameDone) crew.do_frame(first);
  }
  EXPECT_GT(core.tally().ball_ball, 100U) << "else it shows nothing";
  std::vector<Ball> balls = scene.balls;
  core.read_balls(balls);
  return state_hash(Balls(balls));
}

Scene with_fixed_disks(Scene scene) {
  for (std::size_t i = 3; i < scene.balls.size(); i += 20) {
    scene.balls[i].fixed = true;
    scene.balls[i].velocity = {0, 0};
  }
  return scene;
}

Scene in_gravity(Scene scene) {
  scene.effects.gravity = Gravity{{0.1, -0.5}};
  return scene;
}

std::vector<Scene> scenes() {
  const Scene gas = test::gas(16, 16, 0.5);
  const Scene walled = test::walled_gas(16, 16, 0.4);
  return {gas,
          with_fixed_disks(gas),
          walled,
          with_fixed_disks(walled),
          in_gravity(walled),
          in_gravity(with_fixed_disks(walled))};
}

TEST(EventInstances, the_same_scene_has_the_same_bits_whatever_else_is_looked_for) {
  for (const Scene& scene : scenes()) {
    const std::string plain = hash(scene, {});
    EXPECT_EQ(hash(scene, {.rests = true}), plain);
    EXPECT_EQ(hash(scene, {.friction = true}), plain);
    EXPECT_EQ(hash(scene, {.rests = true, .friction = true}), plain);
    EXPECT_EQ(hash(scene, {.parts = 3}), plain);
    if (scene.effects.gravity) continue;
    EXPECT_EQ(hash(scene, {.gravity = true}), plain);
  }
}

}  // namespace
}  // namespace carom::event::event_instances_test
