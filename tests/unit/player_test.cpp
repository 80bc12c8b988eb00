#include "view/player.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "unit/stage.hpp"
#include "view/cost_panel.hpp"
#include "view/keys.hpp"
#include "view/paint.hpp"

namespace carom {
namespace {

using std::chrono::milliseconds;

Scene one_ball() {
  Scene scene;
  scene.name = "one";
  scene.effects.walls.emplace();
  scene.balls.push_back({{3, 5}, {2, 0}});
  return scene;
}

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
}  // namespace carom
