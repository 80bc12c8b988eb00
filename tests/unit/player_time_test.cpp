// Going back and forth in time.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "unit/one_ball.hpp"
#include "unit/stage.hpp"
#include "view/player.hpp"

namespace carom::player_time_test {
namespace {

/// Balls that meet often, with losses, and what a person and a script do.
Scene busy(Method method) {
  Scene scene = one_ball();
  scene.solver.method = method;
  scene.effects.walls = Walls{0.95};
  scene.effects.collisions = Collisions{0.97};
  scene.effects.friction = Friction{0.2, 0.1};
  scene.effects.gravity.emplace().acceleration = {0, -1};
  Fill fill;
  fill.count = 30;
  fill.radius = 0.4;
  fill.temperature = 2;
  scene.fills = {fill};
  scene.script = {{0.7, command::Remove{3}}, {9, command::Remove{}}};
  return scene;
}

std::string hash_of(const Player& player) {
  return player.session().simulation().state_hash();
}
std::string hash_of_run(const Scene& scene) {
  Session session(scene);
  session.advance_clock_to(scene.duration);
  return session.simulation().state_hash();
}

TEST(Player, BackAndForwardAgainGivesTheSameBits) {
  for (const Method method : {Method::event, Method::overlap}) {
    const auto done = [](Stage& stage) {
      stage.key(0.31, 'a');
      stage.key(0.52, 'g');
      stage.key(0.9, 'x');
      stage.key(1.5, 'p');
    };
    Stage plain;
    done(plain);
    plain.key(2, 'q');
    Player player(busy(method), plain);
    player.play();

    Stage stage;
    done(stage);
    stage.keys(2, std::string(25, ','));
    stage.key(3, key::kBackspace);
    stage.keys(3.3, ",,");
    stage.keys(4, std::string(37, '.'));
    stage.key(6, 'q');
    Player again(busy(method), stage);
    again.play();
    EXPECT_TRUE(stage.at(2.9).says(" 32 balls")) << stage.at(2.9).text;
    EXPECT_TRUE(stage.at(3.9).says(" 0.27 s")) << stage.at(3.9).text;
    EXPECT_TRUE(stage.at(3.9).says(" 31 balls")) << "before the first key\n" << stage.at(3.9).text;
    EXPECT_EQ(again.session().simulation().time(), player.session().simulation().time());
    EXPECT_EQ(hash_of(again), hash_of(player));
    // The energy that was dissipated is summed in parts on the way back, and rounds otherwise.
    const auto counts = [](const std::string& summary) {
      return summary.substr(0, summary.find("; energy error"));
    };
    EXPECT_EQ(counts(again.summary()), counts(player.summary()));
    const Scene log = parse_scene(write_scene(again.session().log()), "log");
    EXPECT_EQ(hash_of_run(log), hash_of(player));
  }
}

TEST(Player, GoesOnFromAMomentOfThePastThroughItsCommands) {
  for (const Method method : {Method::event, Method::overlap}) {
    Stage stage;
    stage.key(0.31, 'a');
    stage.key(1, 'p');
    stage.keys(1.2, std::string(25, ','));
    stage.key(2, ' ');
    stage.key(3.5, 'p');
    stage.key(3.7, 'q');
    Player player(busy(method), stage);
    player.play();
    EXPECT_TRUE(stage.at(1.9).says("paused")) << stage.at(1.9).text;
    EXPECT_GT(player.session().simulation().time(), 1.5);
    const Scene log = parse_scene(write_scene(player.session().log()), "log");
    EXPECT_EQ(log.script.size(), 2U) << "what the key and the script did, once";
    EXPECT_EQ(hash_of_run(log), hash_of(player));
  }
}

TEST(Player, ACommandInThePastEndsWhatWasToCome) {
  Stage stage;
  stage.keys(0.5, "aa");
  stage.key(1, 'p');
  stage.keys(1.2, std::string(25, ','));
  stage.key(1.5, 'x');
  stage.keys(2, "....");
  stage.key(3, 'q');
  Player player(busy(Method::event), stage);
  player.play();
  EXPECT_TRUE(stage.at(1.9).says(" 30 balls")) << stage.at(1.9).text;
  EXPECT_LT(player.session().simulation().time(), 0.4);
  const Scene log = parse_scene(write_scene(player.session().log()), "log");
  EXPECT_EQ(log.script.size(), 1U);
  EXPECT_EQ(hash_of_run(log), hash_of(player));
}

TEST(Player, TheBarOfTimeIsShownWhilePausedAndLeadsBack) {
  Stage stage;
  stage.key(1, 'p');
  const auto press = [&](double at, int column) {
    stage.event(at, {Event::Kind::mouse, 0, {Mouse::Action::press, 0, column, 21}});
    stage.event(at, {Event::Kind::mouse, 0, {Mouse::Action::release, 0, column, 21}});
  };
  press(1.5, 0);
  press(2, 79);
  stage.key(2.5, 'q');
  Player player(one_ball(), stage);
  player.play();
  EXPECT_FALSE(stage.at(0.9).says(" MB")) << stage.at(0.9).text;
  EXPECT_TRUE(stage.at(1.4).says(" 0.00 s [=====")) << stage.at(1.4).text;
  EXPECT_TRUE(stage.at(1.4).says("#] 1.00 s  0.0 MB")) << stage.at(1.4).text;
  EXPECT_TRUE(stage.at(1.9).says(" 0.00 s [#----")) << stage.at(1.9).text;
  EXPECT_TRUE(stage.at(1.9).says("  0.00 s  paused")) << stage.at(1.9).text;
  EXPECT_TRUE(stage.at(2.4).says("  1.00 s  paused")) << stage.at(2.4).text;
}

}  // namespace
}  // namespace carom::player_time_test
