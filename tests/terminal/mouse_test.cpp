// The mouse, as a terminal reports it (SGR mode), and what the screen then shows.
#include <gtest/gtest.h>

#include "scenes.hpp"
#include "steps.hpp"
#include "terminal.hpp"

namespace carom::test::mouse_test {
namespace {

// A fixed ball and one at rest in a box of 78 x 20 cells at 80x24: a length is 3.9 columns and 2
// rows, and the box has a column to its left and a row above it.
const char* const kStill = R"({
  "name": "still", "box": {"width": 20, "height": 10}, "effects": {"walls": {}, "collisions": {}},
  "balls": [{"position": [5, 5], "radius": 1, "mass": 3}, {"position": [15, 5], "fixed": true}],
  "solver": {"method": "event"}})";

std::string report(int code, int column, int row, char last = 'M') {
  return "\x1B[<" + std::to_string(code) + ';' + std::to_string(column + 1) + ';' +
         std::to_string(row + 1) + last;
}
std::string click(int column, int row) {
  return report(0, column, row) + report(0, column, row, 'm');
}

/// Where words stand on the screen.
std::pair<int, int> place_of(const Terminal& terminal, const std::string& words) {
  for (int row = 0; row < 24; ++row) {
    const auto column = terminal.row(row).find(words);
    if (column != std::string::npos) return {static_cast<int>(column), row};
  }
  ADD_FAILURE() << words << " is not shown\n" << terminal.text();
  return {0, 0};
}

TEST(MouseOfPlay, AClickAddsABallAtRestAndADragThrowsOne) {
  const SceneFile scene(kStill);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for(" 2 balls")) << terminal.text();
  EXPECT_TRUE(terminal.mode_on("1002"));
  EXPECT_TRUE(terminal.mode_on("1006"));
  terminal.type(click(40, 4));
  EXPECT_TRUE(terminal.wait_for("added a ball at rest")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for(" 3 balls")) << terminal.text();
  terminal.type(report(0, 40, 16));
  terminal.type(report(32, 44, 16) + report(32, 48, 16));
  EXPECT_TRUE(terminal.wait([](const Terminal& t) {
    return t.row(16).substr(40, 9) == "o.......*";
  })) << terminal.text();
  terminal.type(report(0, 48, 16, 'm'));
  // 8 of 78 columns are 8 / 3.9 lengths, twice that in a second.
  EXPECT_TRUE(terminal.wait_for("threw a ball, speed 4.1")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for(" 4 balls")) << terminal.text();
  expect_end_by_key(terminal);
}

TEST(MouseOfPlay, AClickOnABallSelectsItAndTheWordsOfItsPanelAreKeys) {
  const SceneFile scene(kStill);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for(" 2 balls")) << terminal.text();
  terminal.type(click(20, 11));
  ASSERT_TRUE(terminal.wait_for("ball 0 -")) << terminal.text();
  EXPECT_TRUE(terminal.shows("|mass 3 ")) << terminal.text();
  EXPECT_TRUE(terminal.shows("|radius 1 ")) << terminal.text();
  EXPECT_TRUE(terminal.shows("|speed 0 ")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("meets nothing")) << terminal.text();
  EXPECT_TRUE(terminal.shows("worker 0")) << terminal.text();
  EXPECT_FALSE(terminal.shows("spin")) << "balls have none without friction";
  const auto press = [&](const std::string& words) {
    const auto [column, row] = place_of(terminal, words);
    terminal.type(click(column + 2, row));
  };
  press("*:heavier");
  ASSERT_TRUE(terminal.wait_for("|mass 6 ")) << terminal.text();
  press("/:lighter");
  ASSERT_TRUE(terminal.wait_for("|mass 3 ")) << terminal.text();
  press("F:follow");
  ASSERT_TRUE(terminal.wait_for("F:let go")) << terminal.text();
  press("F:let go");
  ASSERT_TRUE(terminal.wait_for("F:follow")) << terminal.text();
  press("X:remove");
  EXPECT_TRUE(terminal.wait_for(" 1 ball ")) << terminal.text();
  EXPECT_TRUE(terminal.wait([](const Terminal& t) { return !t.shows("heavier"); }));
}

TEST(MouseOfPlay, TheWheelZoomsAndWordsOfTheLineOfKeysAreKeys) {
  const SceneFile scene(kStill);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("space:pause")) << terminal.text();
  const auto [space, last] = place_of(terminal, "space:pause");
  terminal.type(click(space + 3, last));
  ASSERT_TRUE(terminal.wait_for("paused")) << terminal.text();
  terminal.type(report(64, 20, 11));
  ASSERT_TRUE(terminal.wait_for("zoom 1.25x")) << terminal.text();
  EXPECT_NE(terminal.row(11).substr(20, 1), " ") << "the ball stays under the pointer";
  terminal.type(report(65, 20, 11));
  ASSERT_TRUE(terminal.wait_for("zoom 1x")) << terminal.text();
}

TEST(MouseOfPlay, WithShiftItIsTheTerminals) {
  const SceneFile scene(kStill);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for(" 2 balls")) << terminal.text();
  terminal.type(report(4, 40, 4) + report(4, 40, 4, 'm') + "g");
  ASSERT_TRUE(terminal.wait_for("this scene has no gravity")) << terminal.text();
  EXPECT_TRUE(terminal.shows(" 2 balls")) << terminal.text();
}

TEST(MouseOfPlay, NoMouseLeavesItToTheTerminal) {
  const SceneFile scene(kStill);
  Terminal terminal({scene.path(), "--no-mouse"});
  ASSERT_TRUE(terminal.wait_for(" 2 balls")) << terminal.text();
  for (const char* const mode : {"1000", "1002", "1003", "1006"})
    EXPECT_EQ(terminal.count(std::string("\x1B[?") + mode), 0U);
  expect_end_by_key(terminal);
}

}  // namespace
}  // namespace carom::test::mouse_test
