#include "carom/scene_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "carom/footprint.hpp"
#include "carom/simulation.hpp"
#include "state/balls.hpp"

namespace carom::scene_file_test {
namespace {

constexpr const char* kBare = R"({"box": {"width": 20, "height": 10}})";

TEST(SceneFile, GivesWhatIsNotSaidItsDefault) {
  const Scene scene = parse_scene(kBare, "bare");
  EXPECT_EQ(scene.box.origin, Box::Origin::corner);
  EXPECT_FALSE(scene.box.periodic[0] || scene.box.periodic[1]);
  EXPECT_FALSE(scene.effects.walls || scene.effects.collisions || scene.effects.gravity);
  EXPECT_TRUE(populate(scene).empty());
  EXPECT_EQ(scene.seed, 0U);
  EXPECT_FALSE(scene.solver.method);
  EXPECT_EQ(scene.solver.step, 1.0 / 240);
  EXPECT_EQ(scene.solver.digits, 16);
  EXPECT_FALSE(scene.workers || scene.per_ball);
  EXPECT_EQ(scene.duration, 10);
  EXPECT_EQ(scene.frame_rate, 30);
  EXPECT_FALSE(scene.continuation);

  const Scene full = parse_scene(
      R"({"box": {"width": 20, "height": 10}, "effects": {"walls": {}, "collisions": {}},
          "balls": [{"position": [3, 5]}], "fill": [{"count": 2}]})",
      "full");
  EXPECT_EQ(full.effects.walls->restitution, 1);
  EXPECT_EQ(full.effects.collisions->restitution, 1);
  EXPECT_EQ(full.balls[0].velocity, Vec2(0, 0));
  EXPECT_EQ(full.balls[0].radius, 0.5);
  EXPECT_EQ(full.balls[0].mass, 1);
  EXPECT_EQ(full.balls[0].spin, 0);
  EXPECT_FALSE(full.balls[0].fixed);
  EXPECT_EQ(full.fills[0].temperature, 0);
  EXPECT_EQ(full.fills[0].arrangement, Fill::Arrangement::random);
  EXPECT_FALSE(full.fills[0].region);
}

TEST(SceneFile, TakesEmptyAndStillScenes) {
  EXPECT_NO_THROW(parse_scene(
      R"({"box": {"width": 1, "height": 1}, "balls": [], "duration": 0, "script": []})", "still"));
}

TEST(SceneFile, TakesWholeNumbersWrittenAsReals) {
  const Scene scene = parse_scene(
      R"({"box": {"width": 20, "height": 10}, "fill": [{"count": 2e1}], "seed": 18446744073709551615})",
      "whole");
  EXPECT_EQ(scene.fills[0].count, 20U);
  EXPECT_EQ(scene.seed, 18446744073709551615U);
}

TEST(SceneFile, TakesBallsThatTouchThoughTheirDecimalsAreRounded) {
  // In double precision 3.3 and 4.3 are less than 1 apart.
  EXPECT_NO_THROW(parse_scene(
      R"({"box": {"width": 20, "height": 10}, "effects": {"walls": {}, "collisions": {}},
          "balls": [{"position": [3.3, 5]}, {"position": [4.3, 5]}, {"position": [5.3, 5]},
                    {"position": [0.1, 0.1], "radius": 0.1}, {"position": [19.9, 9.9], "radius": 0.1}]})",
      "touching"));
  EXPECT_THROW(parse_scene(
                   R"({"box": {"width": 20, "height": 10}, "effects": {"collisions": {}},
              "balls": [{"position": [3.3, 5]}, {"position": [4.2999999999, 5]}]})",
                   "overlapping"),
               SceneError);
}

TEST(SceneFile, LetsBallsOverlapThatDoNotCollide) {
  EXPECT_NO_THROW(parse_scene(R"({"box": {"width": 20, "height": 10}, "effects": {"walls": {}},
                                  "balls": [{"position": [3, 5]}, {"position": [3, 5]}]})",
                              "ideal"));
}

TEST(SceneFile, TakesABallAsTallAsItsBox) {
  EXPECT_NO_THROW(parse_scene(
      R"({"box": {"width": 6, "height": 0.6}, "effects": {"walls": {}, "collisions": {}},
          "balls": [{"position": [3, 0.3], "radius": 0.3}]})",
      "tight"));
}

TEST(SceneFile, SortsTheScriptByTimeAndKeepsLinesOfOneTimeInOrder) {
  const Scene scene = parse_scene(
      R"({"box": {"width": 20, "height": 10}, "effects": {"gravity": [0, -1], "walls": {"restitution": 0.5}},
          "script": [{"at": 3, "command": "quit"}, {"at": 1, "command": "pause"},
                     {"at": 1, "command": "resume"},
                     {"at": 2, "command": "set", "effects": {"walls": {}}, "solver": {"step": 0.5}}]})",
      "script");
  ASSERT_EQ(scene.script.size(), 5U);
  EXPECT_TRUE(std::holds_alternative<command::Pause>(scene.script[0].command));
  EXPECT_TRUE(std::holds_alternative<command::Resume>(scene.script[1].command));
  const auto& set = std::get<command::SetEffects>(scene.script[2].command).effects;
  EXPECT_FALSE(set.gravity) << "only what is named is set";
  EXPECT_EQ(set.walls->restitution, 0.5) << "what is not named keeps its value";
  EXPECT_EQ(std::get<command::SetStep>(scene.script[3].command).step, 0.5);
  EXPECT_TRUE(std::holds_alternative<command::Quit>(scene.script[4].command));
}

TEST(SceneFile, IsNamedAfterItsFileWhereItHasNoName) {
  const std::string file = testing::TempDir() + "nameless.json";
  std::ofstream(file) << kBare;
  EXPECT_EQ(read_scene(file).name, "nameless");
}

TEST(SceneFile, LetsASavedSceneOverlapByWhatItsMethodLeft) {
  EXPECT_NO_THROW(parse_scene(
      R"({"box": {"width": 20, "height": 10}, "effects": {"collisions": {}},
          "balls": [{"position": [3, 5]}, {"position": [3.999, 5]}],
          "continuation": {"time": 1, "clock": 1, "steps": 240}})",
      "saved"));
}

TEST(BuiltinScene, IsTheFileBreakJson) {
  EXPECT_EQ(write_scene(builtin_scene()),
            write_scene(read_scene(CAROM_SOURCE_DIR "/scenes/break.json")));
  EXPECT_EQ(builtin_scene().balls.size(), 16U);
}

TEST(Footprint, CountsTheBytesOfTheColumnsThatTheStateHas) {
  const std::vector<Ball> balls = builtin_scene().balls;
  const Balls state(balls);
  const auto bytes = [](const Balls::Column& column) {
    return static_cast<std::size_t>(column.size()) * sizeof(double);
  };
  const Footprint::Bytes expected{{"position", bytes(state.position[0]) + bytes(state.position[1])},
                                  {"velocity", bytes(state.velocity[0]) + bytes(state.velocity[1])},
                                  {"radius", bytes(state.radius)},
                                  {"mass", bytes(state.mass)},
                                  {"inverse_mass", bytes(state.inverse_mass)},
                                  {"glyph", state.glyph.size()}};
  Scene scene = builtin_scene();
  scene.solver.method = Method::overlap;
  EXPECT_EQ(footprint(scene, balls).columns, expected);
}

TEST(Footprint, HasNoSpinWithoutFrictionAndNoPairsWithoutCollisions) {
  Scene scene = builtin_scene();
  scene.solver.method = Method::overlap;
  const Footprint whole = footprint(scene, populate(scene));
  EXPECT_EQ(whole.pairs, 16U * 15 / 2);
  EXPECT_EQ(whole.workers, 1U);
  const auto has = [](const Footprint::Bytes& parts, const char* name) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const auto& part) { return part.first == name; });
  };
  EXPECT_FALSE(has(whole.columns, "spin"));
  EXPECT_TRUE(has(whole.lists, "pairs"));
  scene.effects.collisions.reset();
  scene.effects.friction.emplace();
  const Footprint bare = footprint(scene, populate(scene));
  EXPECT_TRUE(has(bare.columns, "spin"));
  EXPECT_TRUE(bare.lists.empty());
  EXPECT_EQ(bare.pairs, 0U);
  EXPECT_EQ(bare.barriers,
            (std::vector<std::string>{"do_frame", "wall_computation", "frame_done"}));
}

TEST(Footprint, NamesTheBarriersOfTheCrewThatRuns) {
  for (const char* effects :
       {R"({"walls": {}, "collisions": {}})", R"({"walls": {}})", R"({"collisions": {}})", "{}"}) {
    for (const char* count : {"3", "70", "2100"}) {
      for (const char* workers : {"1", "2", "20"}) {
        const Scene scene = parse_scene(
            fmt::format(
                R"({{"box": {{"width": 40, "height": 20}}, "solver": {{"method": "overlap"}}, "workers": {}, "effects": {},
                            "fill": [{{"radius": 0.1, "count": {}}}]}})",
                workers, effects, count),
            "scene");
        std::vector<std::string> barriers{"do_frame"};
        for (const auto& [name, seconds] : Simulation(scene).measure().phases) {
          barriers.push_back(name);
        }
        barriers.emplace_back("frame_done");
        EXPECT_EQ(footprint(scene, populate(scene)).barriers, barriers) << count << ' ' << workers;
      }
    }
  }
}

TEST(Footprint, HasNoBarrierThatIsNeverMet) {
  const auto barriers = [](std::size_t balls, std::size_t workers) {
    Scene scene;
    scene.effects.walls.emplace();
    scene.effects.collisions.emplace();
    scene.workers = workers;
    scene.solver.method = Method::overlap;
    return footprint(scene, std::vector<Ball>(balls)).barriers;
  };
  const std::vector<std::string> least{"do_frame", "wall_computation", "pair_computation",
                                       "frame_done"};
  EXPECT_EQ(barriers(15, 15), least);
  EXPECT_EQ(barriers(15, 2), least) << "their touching pairs are too few to be shared out";
  EXPECT_EQ(barriers(1000, 1), least) << "there is nobody to share with";
  EXPECT_EQ(barriers(1000, 1000), least) << "to meet costs more than what is shared";
  EXPECT_EQ(barriers(1000, 2),
            (std::vector<std::string>{"do_frame", "wall_computation", "pair_computation",
                                      "pair_resolution", "frame_done"}));
  EXPECT_EQ(barriers(10000, 2),
            (std::vector<std::string>{"do_frame", "wall_computation", "neighbour_search",
                                      "pair_computation", "pair_resolution", "frame_done"}));
}

}  // namespace
}  // namespace carom::scene_file_test
