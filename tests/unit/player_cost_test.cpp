// What a run costs and how wrong it is, the exact run beside it, and the change of method.
#include "view/cost_panel.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/one_ball.hpp"
#include "unit/stage.hpp"
#include "view/paint.hpp"
#include "view/player.hpp"

namespace carom::player_cost_test {
namespace {

/// Two balls that meet at 1.505 s, which steps of 1/4 s see a quarter late.
Scene two_balls() {
  Scene scene;
  scene.name = "two";
  scene.effects.collisions.emplace();
  scene.balls.push_back({{3, 5}, {1, 0}});
  scene.balls.push_back({{7.01, 5}, {-1, 0}});
  scene.solver.method = Method::overlap;
  scene.solver.step = 0.25;
  return scene;
}

TEST(Player, ThePanelTellsWhatTheRunCostsAndHowWrongItIs) {
  Stage stage;
  stage.key(0.5, 'e');
  stage.key(2.5, 'e');
  stage.key(3, 'q');
  Player(two_balls(), stage).play();
  EXPECT_FALSE(stage.at(0.4).says("deepest overlap"));
  EXPECT_TRUE(stage.at(1).says("overlap, step 1/4 s")) << stage.at(1).text;
  EXPECT_TRUE(stage.at(1).says("0.00 ms per frame"));
  EXPECT_TRUE(stage.at(1).says("energy error 0"));
  EXPECT_TRUE(stage.at(1).says("energy dissipated 0"));
  EXPECT_TRUE(stage.at(1).says("deepest overlap 0 of a radius"));
  // At 1.75 they have gone 0.245 too far each.
  EXPECT_TRUE(stage.at(2).says("deepest overlap 9.8e-01 of a radius")) << stage.at(2).text;
  EXPECT_FALSE(stage.at(2.8).says("deepest overlap"));
}

TEST(Player, TheExactRunBesideShowsHowFarTheTwoHaveParted) {
  Stage stage;
  stage.key(0.5, 'E');
  stage.key(2.6, 'E');
  stage.key(3, 'q');
  Player(two_balls(), stage).play();
  EXPECT_TRUE(stage.at(0.6).says("its balls are '+'")) << stage.at(0.6).text;
  EXPECT_TRUE(stage.at(1).says("+ event, 16 digits: 0.00 ms"));
  EXPECT_TRUE(stage.at(1).says("distance 0")) << stage.at(1).text;
  // The exact ones turn back at 1.505, those on screen at 1.75, where both touch again.
  EXPECT_TRUE(stage.at(2.3).says("distance 2.4e-01") || stage.at(2.3).says("distance 2.5e-01"))
      << stage.at(2.3).text;
  // Steps end at quarters of a second: the comparison began at 0.5, and at 1.75 they were apart.
  EXPECT_TRUE(stage.at(1.2).says("step 1/4 s is right so far, 0.5 s")) << stage.at(1.2).text;
  EXPECT_TRUE(stage.at(2.3).says("step 1/4 s is right for 1.25 s here")) << stage.at(2.3).text;
  EXPECT_FALSE(stage.at(2.8).says("distance"));
}

TEST(Player, TheExactRunsBallsAreFaintMarksWhereThePictureIsEmpty) {
  // The ball on screen is held at its first step, the exact one flies on.
  Scene scene = two_balls();
  scene.balls = {{{3, 5}, {0, 0}}};
  Canvas canvas(80, 22);
  Frame frame;
  frame.box = scene.box;
  frame.balls.push_back({{10, 5}, 0.5, 0, false, 0});
  paint_reference(frame, canvas);
  const auto mark = std::find_if(canvas.cells.begin(), canvas.cells.end(),
                                 [](const Cell& cell) { return cell.character == '+'; });
  ASSERT_NE(mark, canvas.cells.end());
  EXPECT_EQ(mark->ink, Ink::ghost);
  EXPECT_EQ(std::count_if(canvas.cells.begin(), canvas.cells.end(),
                          [](const Cell& cell) { return cell.character != ' '; }),
            1);
  paint(frame, canvas);
  const Canvas with_ball = canvas;
  paint_reference(frame, canvas);
  EXPECT_TRUE(std::equal(canvas.cells.begin(), canvas.cells.end(), with_ball.cells.begin(),
                         [](const Cell& a, const Cell& b) { return a.character == b.character; }))
      << "a ball on screen is not marked";
}

TEST(Player, AnAddedBallRestartsTheComparisonAndSaysSo) {
  Stage stage;
  stage.key(0.1, 'E');
  stage.key(2, 'a');
  stage.key(2.5, 'q');
  Player(two_balls(), stage).play();
  EXPECT_TRUE(stage.at(1.99).says("distance 2.")) << stage.at(1.99).text;
  EXPECT_TRUE(stage.at(2.1).says("added a ball; the comparison starts again"))
      << stage.at(2.1).text;
  EXPECT_TRUE(stage.at(2.1).says("distance 0")) << stage.at(2.1).text;
}

TEST(Player, ChangedGravityRestartsTheComparisonAndSaysSo) {
  Scene scene = one_ball();
  scene.effects.gravity.emplace();
  scene.solver.method = Method::overlap;
  Stage stage;
  stage.key(0.1, 'E');
  stage.key(0.5, 'g');
  stage.key(1, 'q');
  Player(scene, stage).play();
  EXPECT_TRUE(stage.at(0.6).says("gravity off; the comparison starts again")) << stage.at(0.6).text;
}

TEST(Player, TheMethodChangesWhereTheRunStands) {
  Stage stage;
  stage.key(0.1, 'e');
  stage.key(0.5, 'm');
  stage.key(2.5, 'm');
  stage.key(3, 'q');
  Player(two_balls(), stage).play();
  EXPECT_TRUE(stage.at(0.6).says("method event"));
  EXPECT_TRUE(stage.at(1).says("event, 16 digits")) << stage.at(1).text;
  EXPECT_TRUE(stage.at(2.4).says("deepest overlap 0 of a radius"))
      << "computed exactly they do not overlap\n"
      << stage.at(2.4).text;
  EXPECT_TRUE(stage.at(2.8).says("overlap, step 1/4 s"));
  EXPECT_TRUE(stage.at(2.8).says("2.8")) << "time goes on\n" << stage.at(2.8).text;
}

TEST(Player, TheMethodChangesWhereItCanNotOnlyWhereItIsTheBetterOne) {
  Scene pile = two_balls();
  pile.effects.gravity.emplace().acceleration = {0, -1};
  pile.effects.walls.emplace().restitution = 0.5;
  Stage stage;
  stage.key(0.1, 'm');
  stage.key(1, 'q');
  Player(pile, stage).play();
  EXPECT_TRUE(stage.at(0.6).says("method event")) << stage.at(0.6).text;
}

TEST(Player, TheMethodStaysWhereTheOtherCannotTakeTheSceneAndSaysWhy) {
  Scene narrow = two_balls();
  narrow.box.height = 1.5;
  narrow.box.periodic[1] = true;
  for (Ball& ball : narrow.balls) ball.position.y() = 0.75;
  Stage stage;
  stage.key(0.1, 'm');
  stage.key(1, 'q');
  Player(narrow, stage).play();
  EXPECT_TRUE(stage.at(0.6).says("method overlap stays: \"event\" needs periodic axes"))
      << stage.at(0.6).text;
}

}  // namespace
}  // namespace carom::player_cost_test
