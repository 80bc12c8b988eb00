// Panels that measure, as keys open them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "unit/stage.hpp"
#include "view/docks.hpp"
#include "view/player.hpp"

namespace carom::panels_test {
namespace {

/// Four balls that meet now and then, two workers.
Scene four_balls(Method method) {
  Scene scene;
  scene.name = "four";
  scene.effects.walls.emplace();
  scene.effects.collisions.emplace();
  scene.solver.method = method;
  scene.workers = 2;
  for (int i = 0; i < 4; ++i)
    scene.balls.push_back({{3.0 + 4 * i, 5.0}, {i % 2 == 0 ? 4.0 : -4.0, 1.0 + i}});
  return scene;
}

/// The rows of the box in a picture: those above the panel.
std::string above_panel(const std::string& text) {
  return text.substr(0, text.find("threads"));
}

TEST(Panels, TheThreadsPanelOpensAndCloses) {
  Stage stage;
  stage.key(0.5, 'l');
  stage.key(1.5, 'l');
  stage.key(2, 'q');
  Player(four_balls(Method::overlap), stage).play();
  EXPECT_FALSE(stage.at(0.4).says("do_frame"));
  for (const char* const words : {"do_frame", "frame_done", "control", "worker 0", "worker 1",
                                  "# computes", "~ waits", " waiting "})
    EXPECT_TRUE(stage.at(1).says(words)) << words << '\n' << stage.at(1).text;
  EXPECT_FALSE(stage.at(1.8).says("do_frame")) << stage.at(1.8).text;
}

TEST(Panels, SlowMotionPassesEveryBarrierAndShowsTheNewPositionsAtTheLast) {
  const std::vector<std::string> barriers{"do_frame: The control", "wall_computation: Every ball",
                                          "pair_computation: Every pair",
                                          "frame_done: All workers"};
  Stage stage;
  stage.key(0.5, 'L');
  for (std::size_t k = 0; k < 2 * barriers.size(); ++k) stage.key(1 + static_cast<double>(k), '.');
  stage.key(10, ' ');
  stage.key(12, 'q');
  Scene scene = four_balls(Method::overlap);
  scene.solver.step = 0.25;  // so that a step is seen
  Player(scene, stage).play();
  EXPECT_TRUE(stage.at(0.8).says("paused")) << stage.at(0.8).text;
  EXPECT_TRUE(stage.at(0.8).says("All workers wait at do_frame")) << stage.at(0.8).text;
  std::string last = above_panel(stage.at(0.8).text);
  for (std::size_t k = 0; k < 2 * barriers.size(); ++k) {
    const Stage::Shot& shot = stage.at(1.5 + static_cast<double>(k));
    EXPECT_TRUE(shot.says(barriers[k % barriers.size()])) << k << shot.text;
    EXPECT_TRUE(shot.says(fmt::format("barrier {} of 4", k % 4 + 1))) << shot.text;
    const bool done = k % barriers.size() == 3;
    const std::string picture = above_panel(shot.text);
    EXPECT_EQ(picture != last, done) << k << '\n' << picture << last;
    last = picture;
  }
  EXPECT_TRUE(stage.at(11.9).says("four")) << stage.at(11.9).text;
  EXPECT_FALSE(stage.at(11.9).says("slow motion")) << "running again";
  EXPECT_FALSE(stage.at(11.9).says("paused"));
}

TEST(Panels, SlowMotionOfExactEventsNamesItsPathsAndGroups) {
  Stage stage;
  stage.key(0.5, 'L');
  for (int k = 0; k < 6; ++k) stage.key(1 + k, '.');
  stage.key(9, 'q');
  Player(four_balls(Method::event), stage).play();
  EXPECT_TRUE(stage.at(1.5).says("do_frame: ")) << stage.at(1.5).text;
  EXPECT_TRUE(stage.at(2.5).says("wall_computation: The path of every ball")) << stage.at(2.5).text;
  EXPECT_TRUE(stage.at(3.5).says("pair_computation: ")) << stage.at(3.5).text;
}

TEST(Panels, TheInstrumentsShowTemperatureAndEnergies) {
  Stage stage;
  stage.key(0.5, 'h');
  stage.key(2.5, 'h');
  stage.key(3, 'q');
  Player(four_balls(Method::event), stage).play();
  EXPECT_FALSE(stage.at(0.4).says("temperature"));
  // Kinetic energy (4 * 16 + 1 + 4 + 9 + 16) / 2 of four balls of mass 1.
  for (const char* const words : {"temperature", "pressure", "impacts / s", "kinetic    47",
                                  "potential  0", "dissipated 0", "error", "mean of 1"})
    EXPECT_TRUE(stage.at(2).says(words)) << words << '\n' << stage.at(2).text;
  EXPECT_FALSE(stage.at(2.9).says("temperature"));
}

TEST(Panels, ThatWasOpenedLastIsShownWhereThereIsRoomForOne) {
  Stage stage;
  stage.keys(0.2, "hl");
  stage.key(1, 'h');
  stage.key(1.2, 'h');
  stage.key(2, 'q');
  Player(four_balls(Method::overlap), stage).play();
  EXPECT_TRUE(stage.at(0.8).says("do_frame")) << stage.at(0.8).text;
  EXPECT_FALSE(stage.at(0.8).says("temperature"));
  EXPECT_TRUE(stage.at(1.8).says("temperature")) << stage.at(1.8).text;
  EXPECT_FALSE(stage.at(1.8).says("do_frame"));
}

TEST(Panels, GoBackInTimeWithTheRun) {
  Stage stage;
  stage.resize(0.1, {120, 40});
  stage.keys(0.2, "hlzv");
  stage.key(2, 'p');
  for (int k = 0; k < 10; ++k) stage.key(2.5 + 0.1 * k, ',');
  stage.key(4, 'L');
  for (int k = 0; k < 4; ++k) stage.key(4.5 + 0.5 * k, '.');
  stage.key(7, ' ');
  stage.key(9, 'q');
  Player(four_balls(Method::overlap), stage).play();
  EXPECT_TRUE(stage.at(4.8).says("do_frame: ")) << stage.at(4.8).text;
  EXPECT_TRUE(stage.at(5.2).says("wall_computation: ")) << stage.at(5.2).text;
  EXPECT_TRUE(stage.at(8.9).says("kinetic    47")) << stage.at(8.9).text;
  EXPECT_TRUE(stage.at(8.9).says("frame_done")) << stage.at(8.9).text;
}

TEST(Panels, SayWhereTheScreenIsTooSmallForThem) {
  for (const char key : {'h', 'l'}) {
    Stage stage;
    stage.resize(0.1, {20, 8});
    stage.key(0.5, key);
    stage.key(1, 'q');
    Player(four_balls(Method::event), stage).play();
    EXPECT_TRUE(stage.at(0.8).says("the screen is too")) << stage.at(0.8).text;
  }
}

TEST(Docks, GiveTheBoxHalfOfTheScreenEachWayAndOverlapNothing) {
  Box box;
  for (const double height : {0.1, 10.0, 300.0}) {
    box = {20, height};
    for (int columns = 1; columns <= 300; columns += 7) {
      for (int rows = 1; rows <= 100; rows += 3) {
        for (int open = 0; open < 8; ++open) {
          const DockWishes wishes{open & 1 ? 40 : 0, open & 2 ? 20 : 0, open & 4 ? 9 : 0, false};
          const Docks docks = docks_for(wishes, box, columns, rows);
          EXPECT_GT(2 * docks.box.columns, columns);
          if (height == 300 && columns > 20) {
            EXPECT_GE(2 * docks.box.rows, rows) << "it needs them";
          }
          std::vector<int> used(static_cast<std::size_t>(columns * rows));
          for (const CellRect& each : {docks.box, docks.threads, docks.instruments, docks.cost}) {
            for (int row = each.row; row < each.row + each.rows; ++row) {
              ASSERT_LE(row, rows - 1);
              for (int column = each.column; column < each.column + each.columns; ++column) {
                ASSERT_LE(column, columns - 1);
                ASSERT_EQ(used[static_cast<std::size_t>(row * columns + column)]++, 0);
              }
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace carom::panels_test
