// Keys, the help that names them, and what many of them at once do.
#include "view/keys.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "unit/one_ball.hpp"
#include "unit/stage.hpp"
#include "view/player.hpp"

namespace carom::player_keys_test {
namespace {

using std::chrono::milliseconds;

TEST(Player, TurnsThePagesOfTheHelpAndClosesIt) {
  for (const UserInterface::Size size : {UserInterface::Size{80, 24}, {20, 8}, {300, 100}}) {
    Stage stage;
    stage.resize(0, size);
    for (int i = 1; i <= 14; ++i) stage.key(i, '?');
    stage.key(15, 'q');
    stage.key(16, 'q');
    Player player(one_ball(), stage);
    player.play();
    std::string seen;
    for (const Stage::Shot& shot : stage.shots) seen += shot.text;
    for (const char* const words : {"space p", "one frame", "add a ball", "quit", "Esc"})
      EXPECT_NE(seen.find(std::string(words).substr(0, 7)), std::string::npos) << words;
    EXPECT_TRUE(stage.at(1.5).says("Time")) << stage.at(1.5).text;
    EXPECT_FALSE(stage.at(15.5).says("Time"));
  }
}

TEST(Player, EscapeEnterAndQCloseTheHelp) {
  for (const int close : {key::kEscape, key::kEnter, int{'q'}}) {
    Stage stage;
    stage.key(1, '?');
    stage.key(2, close);
    stage.key(3, 'q');
    Player player(one_ball(), stage);
    player.play();
    EXPECT_TRUE(stage.at(1.5).says("remove the newest ball")) << stage.at(1.5).text;
    EXPECT_FALSE(stage.at(2.5).says("remove the newest ball")) << stage.at(2.5).text;
    EXPECT_NEAR(stage.seconds(), 3, 0.1);
  }
}

TEST(Player, EveryKeyOfTheHelpDoesSomethingAndNoOtherDoes) {
  std::string told;
  for (const KeyHelp& line : kKeyHelp) {
    if (line.keys == "space p")
      told += " p";
    else if (line.keys.size() == 1 || line.keys[1] == ' ')
      told += line.keys;
  }
  for (char each = '!'; each <= '~'; ++each) {
    Stage stage;
    stage.key(0.1, each);
    stage.key(0.3, 'q');
    stage.key(0.4, 'q');
    Player(one_ball(), stage).play();
    const bool known = told.find(each) != std::string::npos || each == '=' || each == '_';
    EXPECT_EQ(stage.shots.back().says("no such key"), !known) << each << stage.shots.back().text;
  }
}

TEST(Player, QuitAndPauseGoAheadOfAllThatWaits) {
  // Each look at the clock costs: acting on every key would take seconds.
  for (const std::string& flood :
       {std::string(300, '['), std::string(300, 'A'), std::string(301, 'm')}) {
    Scene scene = one_ball();
    scene.solver.method = Method::overlap;
    Stage stage;
    stage.looking = milliseconds{1};
    stage.keys(0.5, flood);
    stage.key(0.5, 'q');
    Player player(scene, stage);
    player.play();
    EXPECT_LT(stage.seconds(), 1) << flood[0];
    EXPECT_LT(player.session().simulation().balls(), 20U);
  }
  Stage stage;
  stage.keys(0.5, std::string(300, 'a'));
  stage.key(0.5, 'p');
  stage.key(5, 'q');
  Player player(one_ball(), stage);
  player.play();
  EXPECT_TRUE(stage.at(0.6).says("paused")) << stage.at(0.6).text;
}

TEST(Player, BoundsTheStepAndCountsRepeatsTogether) {
  Scene scene = one_ball();
  scene.solver.method = Method::overlap;
  Stage stage;
  stage.keys(0.5, "[[");
  stage.keys(1, std::string(300, '['));
  stage.keys(1.5, "[");
  stage.keys(2, std::string(300, ']'));
  stage.key(2.5, 'q');
  Player(scene, stage).play();
  EXPECT_TRUE(stage.at(0.8).says("step 1/960 s")) << stage.at(0.8).text;
  EXPECT_TRUE(stage.at(1.2).says("step 1/30720 s")) << stage.at(1.2).text;
  EXPECT_TRUE(stage.at(1.8).says("step stays 1/30720 s")) << stage.at(1.8).text;
  EXPECT_TRUE(stage.at(2.4).says("step 1/15 s")) << stage.at(2.4).text;
}

TEST(Player, MethodEventHasNoStep) {
  Stage stage;
  stage.key(0.5, '[');
  stage.key(1.5, 'q');
  Player(one_ball(), stage).play();
  EXPECT_TRUE(stage.at(0.7).says("no step with method event")) << stage.at(0.7).text;
}

TEST(Player, AnEffectComesBackWithTheValuesOfTheScript) {
  Scene scene = one_ball();
  scene.solver.method = Method::event;
  scene.effects.gravity.emplace().acceleration = {0, -1};
  command::SetEffects set;
  set.effects.gravity.emplace().acceleration = {0, -3};
  scene.script = {{0.5, set}};
  Stage stage;
  stage.key(1, 'g');
  stage.key(1.5, 'g');
  stage.key(2, 'q');
  Player player(scene, stage);
  player.play();
  EXPECT_TRUE(stage.at(1.2).says("gravity off")) << stage.at(1.2).text;
  EXPECT_TRUE(stage.at(1.7).says("gravity on")) << stage.at(1.7).text;
  EXPECT_EQ(player.session().simulation().effects().gravity->acceleration.y(), -3);
}

TEST(Player, PastedTextIsNoCommand) {
  Stage stage;
  stage.event(0.5, {Event::Kind::pasted, 0, {}});
  stage.key(1, 'q');
  Player(one_ball(), stage).play();
  EXPECT_TRUE(stage.at(0.7).says("pasted text is ignored")) << stage.at(0.7).text;
}

TEST(Player, SaysThatAKeyIsNone) {
  Stage stage;
  stage.key(0.1, 'Z');
  stage.key(0.5, 0);
  stage.key(0.9, 'q');
  Player player(one_ball(), stage);
  player.play();
  EXPECT_TRUE(stage.at(0.2).says("no such key: Z (? for help)"));
  EXPECT_TRUE(stage.at(0.6).says("no such key (? for help)"));
}

TEST(Player, ShowsFramesUnderAFloodOfKeys) {
  Stage stage;
  stage.looking = milliseconds{1};
  for (int i = 0; i < 2000; ++i) stage.key(0.1, '.');
  stage.key(5, 'q');
  Player player(one_ball(), stage);
  player.play();
  const auto during = std::count_if(stage.shots.begin(), stage.shots.end(), [](const auto& shot) {
    return shot.at > 0.2 && shot.at < 1.2;
  });
  EXPECT_GE(during, 10);
}

}  // namespace
}  // namespace carom::player_keys_test
