// The list of scenes to choose from.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "unit/one_ball.hpp"
#include "unit/stage.hpp"
#include "view/player.hpp"

namespace carom::player_scenes_test {
namespace {

/// A library of two scenes, of which one cannot be played.
Settings with_library() {
  Settings settings;
  settings.scene_library.names = {"good", "bad"};
  settings.scene_library.load = [](const std::string& name) {
    Scene scene = one_ball();
    scene.name = name;
    scene.about = "about the " + name + " one";
    if (name == "bad") throw SceneError("bad.json", {{"/balls", "this one is bad"}});
    scene.balls.push_back({{8, 5}, {0, 1}});
    return scene;
  };
  return settings;
}

TEST(Player, PlaysTheSceneThatIsChosenFromTheList) {
  Stage stage;
  stage.key(0.5, key::kTab);
  stage.key(1.5, key::kEnter);
  stage.key(2.5, 'q');
  Player player(one_ball(), stage, with_library());
  player.play();
  EXPECT_TRUE(stage.at(1.4).says("about the good one")) << stage.at(1.4).text;
  EXPECT_TRUE(stage.at(1.4).says("scenes, 2")) << stage.at(1.4).text;
  EXPECT_NE(stage.at(1.0).text, stage.at(1.4).text) << "the preview moves";
  EXPECT_TRUE(stage.at(2).says("good  2 balls")) << stage.at(2).text;
  EXPECT_LT(player.session().simulation().time(), 1.1);
}

TEST(Player, TheSceneStandsStillBehindTheListAndStaysWhereTheOtherIsBad) {
  Stage stage;
  stage.key(0.5, key::kTab);
  stage.keys(0.8, " p");
  stage.key(1, key::kDown);
  stage.key(2, key::kEnter);
  stage.key(2.2, key::kEscape);
  stage.key(3.2, 'q');
  Player player(one_ball(), stage, with_library());
  player.play();
  EXPECT_TRUE(stage.at(1.9).says("this one is bad")) << stage.at(1.9).text;
  EXPECT_TRUE(stage.at(2.1).says("this one is bad")) << stage.at(2.1).text;
  EXPECT_TRUE(stage.at(3).says("one  1 ball ")) << stage.at(3).text;
  EXPECT_FALSE(stage.at(3).says("paused")) << "no key of the list pauses";
  EXPECT_NEAR(player.session().simulation().time(), 1.5, 0.1);
}

TEST(Player, WithoutALibraryOrAFolderItSaysSo) {
  Stage stage;
  stage.key(0.5, key::kTab);
  stage.key(1, 's');
  stage.key(1.5, 'o');
  stage.key(2, 'q');
  Player(one_ball(), stage).play();
  EXPECT_TRUE(stage.at(0.8).says("no scenes to choose from"));
  EXPECT_TRUE(stage.at(1.3).says("no folder to write to"));
  EXPECT_TRUE(stage.at(1.8).says("no folder to write to"));
}

}  // namespace
}  // namespace carom::player_scenes_test
