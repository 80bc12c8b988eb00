#include "view/player.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "unit/one_ball.hpp"
#include "unit/stage.hpp"

namespace carom::player_test {
namespace {

using std::chrono::milliseconds;

TEST(Player, ShowsThirtyFramesASecondAtTheirTimes) {
  Stage stage;
  stage.key(1.99, 'q');
  Player player(one_ball(), stage);
  EXPECT_EQ(player.play(), 0);
  ASSERT_EQ(stage.shots.size(), 60U);
  for (std::size_t i = 0; i < stage.shots.size(); ++i)
    EXPECT_NEAR(stage.shots[i].at, static_cast<double>(i) / 30, 1e-6);
  EXPECT_NE(player.summary().find("60 frames, 0 late"), std::string::npos) << player.summary();
  EXPECT_NE(stage.shots.front().text, stage.shots.back().text);
}

TEST(Player, CountsFramesGivenUpAsLateAndStaysOnTheBeat) {
  Stage stage;
  stage.drawing = milliseconds{50};  // more than one period, less than two
  stage.key(1, 'q');
  Player player(one_ball(), stage);
  player.play();
  for (std::size_t i = 1; i < stage.shots.size(); ++i)
    EXPECT_NEAR(stage.shots[i].at - stage.shots[i - 1].at, 2.0 / 30, 1e-6);
  EXPECT_TRUE(stage.shots.back().says(fmt::format(" {} frames late", stage.shots.size() - 1)))
      << stage.shots.back().text;
}

TEST(Player, SlowsASimulationDownThatCannotKeepUpAndSaysSo) {
  Stage stage;
  stage.looking = milliseconds{6};  // what each step seems to take: eight do not fit into a frame
  stage.key(3, 'p');
  stage.key(3.1, 'q');
  Player player(one_ball(), stage);
  player.play();
  EXPECT_TRUE(stage.at(2.9).says("too slow: ")) << stage.at(2.9).text;
  EXPECT_TRUE(stage.at(3.1).says("paused")) << "the key waits for no simulation";
}

TEST(Player, PausesGoesOnAndShowsSingleFrames) {
  Stage stage;
  stage.key(0.5, ' ');
  stage.key(0.8, '.');
  stage.key(1.0, '.');
  stage.key(1.2, 'p');
  stage.key(1.4, 'q');
  Player player(one_ball(), stage);
  player.play();
  EXPECT_TRUE(stage.at(0.55).says("paused"));
  EXPECT_TRUE(stage.at(0.55).says("0.50 s")) << stage.at(0.55).text;
  EXPECT_TRUE(stage.at(0.75).says("0.50 s"));
  EXPECT_TRUE(stage.at(0.9).says("0.53 s")) << stage.at(0.9).text;
  EXPECT_TRUE(stage.at(1.1).says("0.57 s")) << stage.at(1.1).text;
  EXPECT_TRUE(stage.at(1.39).says("0.7"));
  EXPECT_FALSE(stage.at(1.39).says("paused"));
}

TEST(Player, DrawsNothingWhilePausedWithNothingToDo) {
  Stage stage;
  stage.key(0.5, ' ');
  stage.key(100, 'q');
  Player player(one_ball(), stage);
  player.play();
  EXPECT_LE(stage.shots.size(), 18U);
}

TEST(Player, ObeysTheScriptWhilePaused) {
  Scene scene = one_ball();
  scene.script = {{0.5, command::Pause{}}, {1, command::Resume{}}, {1.5, command::Quit{}}};
  Stage stage;
  Player player(scene, stage);
  EXPECT_EQ(player.play(), 0);
  EXPECT_NEAR(stage.seconds(), 1.5, 0.1);
  EXPECT_TRUE(stage.at(0.9).says("paused"));
  EXPECT_FALSE(stage.at(1.4).says("paused"));
}

TEST(Player, ChangesTheSpeedByTwo) {
  Stage stage;
  stage.key(0, '+');
  stage.key(0, '+');
  stage.key(1, '-');
  stage.key(2, 'q');
  Player player(one_ball(), stage);
  player.play();
  EXPECT_TRUE(stage.at(0.1).says("speed 4x"));
  EXPECT_TRUE(stage.at(1.04).says("speed 2x"));
  EXPECT_NE(player.summary().find("one: 6.0"), std::string::npos) << player.summary();
}

TEST(Player, ARunOfItsLogEndsInTheSameBits) {
  for (const Method method : {Method::event, Method::overlap}) {
    Scene scene = one_ball();
    scene.solver.method = method;
    scene.effects.collisions.emplace();
    scene.effects.gravity.emplace().acceleration = {0, -1};
    scene.script = {{0.4, command::Remove{}}, {0.6, command::Pause{}}, {0.7, command::Resume{}}};
    Stage stage;
    stage.keys(0.21, "aA");
    stage.keys(0.5, "g[+");
    stage.keys(0.91, "p...xap-]");
    stage.keys(1.3, "w");
    stage.key(1.77, 'q');
    Player player(scene, stage);
    player.play();
    const Scene log = parse_scene(write_scene(player.session().log()), "log");
    EXPECT_GE(log.script.size(), 15U);
    Session session(log);
    session.advance_clock_to(log.duration);
    EXPECT_EQ(session.simulation().state_hash(), player.session().simulation().state_hash());
  }
}

TEST(Player, RestartsFromTheBeginning) {
  Stage stage;
  stage.key(1, 'r');
  stage.key(1.5, 'q');
  Player player(one_ball(), stage);
  player.play();
  EXPECT_TRUE(stage.at(1.05).says("restarted"));
  EXPECT_NE(player.summary().find("one: 0.5"), std::string::npos) << player.summary();
}

TEST(Player, EndsWithTheNumberOfTheSignal) {
  Stage stage;
  stage.event(0.2, {Event::Kind::ended, SIGTERM, {}});
  Player player(one_ball(), stage);
  EXPECT_EQ(player.play(), SIGTERM);
}

TEST(Player, DoesNotCountTheTimeThatItWasStopped) {
  Stage stage;
  stage.stop(0.5, std::chrono::seconds{1000});
  stage.key(1001.01, 'q');
  Player player(one_ball(), stage);
  player.play();
  EXPECT_FALSE(stage.shots.back().says(" late")) << stage.shots.back().text;
  EXPECT_NE(player.summary().find("one: 1.0"), std::string::npos) << player.summary();
}

TEST(Player, SaysHowSmallIsTooSmallAndGoesOn) {
  Stage stage;
  stage.resize(0.2, {19, 8});
  stage.resize(0.4, {1, 1});
  stage.resize(0.6, {0, 0});
  stage.resize(0.8, {20, 8});
  stage.resize(1.0, {300, 100});
  stage.key(1.2, 'q');
  Player player(one_ball(), stage);
  player.play();
  EXPECT_TRUE(stage.at(0.3).says("too small"));
  EXPECT_EQ(stage.at(0.5).text, "t\n");
  EXPECT_EQ(stage.at(0.7).text, "");
  EXPECT_FALSE(stage.at(0.9).says("too small"));
  EXPECT_TRUE(stage.at(0.9).says("1 ball")) << stage.at(0.9).text;
  EXPECT_EQ(std::count(stage.at(1.1).text.begin(), stage.at(1.1).text.end(), '\n'), 100);
}

}  // namespace
}  // namespace carom::player_test
