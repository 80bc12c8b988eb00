// The bits of a run with every effect: the same for any number of workers, frames, stopped or not.
#include <gtest/gtest.h>

#include "carom/report.hpp"
#include "carom/scene_file.hpp"
#include "carom/session.hpp"

namespace carom::effects_test {
namespace {

Scene everything(Method method) {
  Scene scene = read_scene(CAROM_SOURCE_DIR "/scenes/everything.json");
  scene.solver.method = method;
  scene.solver.step = 1.0 / 120;
  scene.workers = 1;
  command::SetEffects change;
  change.effects.attraction = Attraction{-0.3, 0.2};
  change.effects.drag = Drag{0.3};
  command::SetEffects open;
  open.effects.collisions = switched_off(*scene.effects.collisions);
  Ball ball{{1, 9}, {2, 0}, 0.3};
  ball.spin = 3;
  scene.script = {
      {0.4, change}, {0.6, command::Add{ball}}, {0.75, open}, {0.9, command::Remove{4}}};
  return scene;
}

std::string hash_of(const Scene& scene, double time, double frame) {
  Session session(scene);
  for (int k = 1; k * frame < time; ++k) session.advance_clock_to(k * frame);
  session.advance_clock_to(time);
  return session.simulation().state_hash();
}

class AllEffects : public testing::TestWithParam<Method> {};

TEST_P(AllEffects, GiveTheSameBitsForAnyNumberOfWorkers) {
  Scene scene = everything(GetParam());
  const std::string expected = hash_of(scene, 1.3, 1.0 / 30);
  for (const std::size_t workers : {2, 3, 7}) {
    scene.workers = workers;
    EXPECT_EQ(hash_of(scene, 1.3, 1.0 / 30), expected) << workers;
  }
  scene.workers.reset();
  scene.per_ball = true;
  EXPECT_EQ(hash_of(scene, 1.3, 1.0 / 30), expected);
}

TEST_P(AllEffects, GiveTheSameBitsAtAnyFrameRate) {
  const Scene scene = everything(GetParam());
  const std::string expected = hash_of(scene, 1.3, 1.3);
  for (const double frame : {1.0 / 7, 1.0 / 30, 1.0 / 1000}) {
    EXPECT_EQ(hash_of(scene, 1.3, frame), expected) << frame;
  }
}

TEST_P(AllEffects, GoOnFromASavedRunWithTheSameBits) {
  const Scene scene = everything(GetParam());
  for (const double stop : {0.25, 0.503, 0.81, 1.117}) {
    Session first(scene);
    first.advance_clock_to(stop);
    Session second(parse_scene(write_scene(first.save()), "saved"));
    EXPECT_EQ(second.simulation().state_hash(), first.simulation().state_hash()) << stop;
    second.advance_clock_to(1.3);
    EXPECT_EQ(second.simulation().state_hash(), hash_of(scene, 1.3, 1.3)) << stop;
  }
}

TEST_P(AllEffects, AreHashedWithTheirSpins) {
  Scene scene = everything(GetParam());
  scene.script.clear();
  scene.fills.clear();
  scene.balls = {Ball{{5, 5}}};
  const std::string still = hash_of(scene, 0, 1);
  scene.balls[0].spin = 1;
  EXPECT_NE(hash_of(scene, 0, 1), still);
  scene.effects.friction.reset();
  const std::string without = hash_of(scene, 0, 1);
  scene.balls[0].spin = 0;
  EXPECT_EQ(hash_of(scene, 0, 1), without);
}

INSTANTIATE_TEST_SUITE_P(Methods, AllEffects, testing::Values(Method::overlap, Method::event),
                         [](const auto& each) { return method_name(each.param); });

}  // namespace
}  // namespace carom::effects_test
