// The player in a terminal: its picture, its keys and what it writes.
#include <gtest/gtest.h>

#include <set>

#include "scenes.hpp"
#include "steps.hpp"
#include "terminal.hpp"

namespace carom::test::play_test {
namespace {

TEST(Play, ShowsTheBuiltInSceneMovingFrameByFrame) {
  Terminal terminal(std::vector<std::string>{});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  EXPECT_TRUE(terminal.alternate_screen());
  EXPECT_FALSE(terminal.cursor_visible());
  std::set<double> times;
  std::set<std::string> pictures;
  const auto start = std::chrono::steady_clock::now();
  terminal.watch(std::chrono::milliseconds{1500}, [&] {
    times.insert(shown_time(terminal));
    pictures.insert(terminal.row(10) + terminal.row(11));
  });
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  // Never more than thirty a second; how many fewer is the machine's affair.
  EXPECT_LE(static_cast<double>(times.size()), 30 * elapsed.count() + 3);
  EXPECT_GE(times.size(), 5U);
  EXPECT_GE(pictures.size(), 3U);
  expect_end_by_key(terminal);
  EXPECT_NE(terminal.text().find("carom: break: "), std::string::npos) << terminal.text();
  EXPECT_NE(terminal.text().find(" late"), std::string::npos);
}

TEST(Play, DoesWhatEachKeySays) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal({"play", scene.path()});
  ASSERT_TRUE(terminal.wait_for(" 3 balls")) << terminal.text();
  EXPECT_TRUE(terminal.shows("three"));

  terminal.type("p");
  ASSERT_TRUE(terminal.wait_for("paused")) << terminal.text();
  const double stopped = shown_time(terminal);
  terminal.type(".");
  EXPECT_TRUE(terminal.wait([&](const Terminal& t) {
    return shown_time(t) > stopped + 0.02 && t.shows("one frame");
  })) << terminal.text();
  EXPECT_LT(shown_time(terminal), stopped + 0.06);

  terminal.type("a");
  EXPECT_TRUE(terminal.wait_for(" 4 balls")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("added a ball")) << terminal.text();
  EXPECT_TRUE(terminal.shows(" 4 workers")) << terminal.text();
  terminal.type("A");
  EXPECT_TRUE(terminal.wait_for(" 14 balls")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("added 10 balls")) << terminal.text();
  terminal.type("x");
  EXPECT_TRUE(terminal.wait_for(" 13 balls")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("removed the newest ball")) << terminal.text();

  terminal.type(" ");
  EXPECT_TRUE(terminal.wait([&](const Terminal& t) {
    return shown_time(t) > stopped + 0.1 && !t.shows("paused");
  })) << terminal.text();
  terminal.type("+");
  EXPECT_TRUE(terminal.wait_for("speed 2x")) << terminal.text();
  terminal.type("-");
  EXPECT_TRUE(terminal.wait_for("speed 1x")) << terminal.text();
  terminal.type("[");
  EXPECT_TRUE(terminal.wait_for("step 1/480 s")) << terminal.text();
  terminal.type("]");
  EXPECT_TRUE(terminal.wait_for("step 1/240 s")) << terminal.text();
  terminal.type("g");
  EXPECT_TRUE(terminal.wait_for("gravity off")) << terminal.text();
  terminal.type("g");
  EXPECT_TRUE(terminal.wait_for("gravity on")) << terminal.text();
  terminal.type("?");
  EXPECT_TRUE(terminal.wait_for("pause, and go on")) << terminal.text();
  terminal.type("\x1B");
  EXPECT_TRUE(terminal.wait([](const Terminal& t) { return !t.shows("pause, and go on"); }))
      << terminal.text();
  terminal.type("r");
  EXPECT_TRUE(terminal.wait_for(" 3 balls")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("restarted")) << terminal.text();
  expect_end_by_key(terminal);
}

TEST(Play, DrawsWithTheGlyphsOfItsOptionAtItsFrameRate) {
  const SceneFile scene(kThreeBalls);
  // Half-blocks are U+2580 and U+2584; patterns of braille begin with the bytes E2 A0 to E2 A3.
  Terminal blocks({scene.path(), "--glyphs", "blocks", "--fps", "10"});
  ASSERT_TRUE(blocks.wait_for("fps")) << blocks.text();
  std::set<double> times;
  const auto start = std::chrono::steady_clock::now();
  blocks.watch(std::chrono::milliseconds{1500}, [&] { times.insert(shown_time(blocks)); });
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_LE(static_cast<double>(times.size()), 10 * elapsed.count() + 3);
  EXPECT_GT(blocks.count("\xE2\x96\x80") + blocks.count("\xE2\x96\x84"), 0U);
  expect_end_by_key(blocks);

  Terminal braille({scene.path(), "--glyphs", "braille"});
  ASSERT_TRUE(braille.wait_for("fps")) << braille.text();
  std::size_t patterns = 0;
  for (const char* const start_of : {"\xE2\xA0", "\xE2\xA1", "\xE2\xA2", "\xE2\xA3"})
    patterns += braille.count(start_of);
  EXPECT_GT(patterns, 0U);
  expect_end_by_key(braille);
}

TEST(Play, SaysThatASceneHasNoGravity) {
  Terminal terminal(std::vector<std::string>{});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  terminal.type("g");
  EXPECT_TRUE(terminal.wait_for("this scene has no gravity")) << terminal.text();
}

TEST(Play, SwitchesEveryEffectOfTheSceneOffAndOn) {
  const SceneFile scene(R"({"box": {"width": 20, "height": 10}, "effects": {
    "walls": {}, "collisions": {}, "gravity": [0, -1], "drag": {"rate": 0.1},
    "friction": {"balls": 0.1}, "attraction": {"strength": 0.1, "softening": 1}},
    "balls": [{"position": [5, 5]}, {"position": [10, 5], "velocity": [1, 0]}]})");
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("wcgdft:on/off")) << terminal.text();
  const std::vector<std::pair<std::string, std::string>> keys{
      {"w", "walls"}, {"c", "collisions"}, {"g", "gravity"},
      {"d", "drag"},  {"f", "friction"},   {"t", "attraction"}};
  for (const auto& [key, name] : keys) {
    terminal.type(key);
    EXPECT_TRUE(terminal.wait_for(" " + name + " off")) << terminal.text();
    terminal.type(key);
    EXPECT_TRUE(terminal.wait_for(" " + name + " on")) << terminal.text();
  }
  expect_end_by_key(terminal);
}

TEST(Play, FollowsTheSizeOfTheScreen) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  struct {
    int columns;
    int rows;
  } const sizes[] = {{20, 8}, {300, 100}, {10, 3}, {40, 40}, {200, 10}, {1, 1}, {80, 24}};
  for (const auto& size : sizes) {
    terminal.resize(size.columns, size.rows);
    const bool fits = size.columns >= 20 && size.rows >= 8;
    EXPECT_TRUE(terminal.wait([&](const Terminal& t) {
      if (!fits) return t.row(0)[0] == 't';
      // The box touches the edges one way or the other, and the status is in its row below.
      const int box_rows = status_row(size.rows);
      const std::string middle = t.row(box_rows / 2);
      const bool wide = middle.front() == '|' && middle.back() == '|';
      const bool high = t.row(0).find("+-") != std::string::npos &&
                        t.row(box_rows - 1).find("-+") != std::string::npos;
      return (wide || high) && t.row(box_rows).find("s ") != std::string::npos &&
             !t.shows("too small");
    })) << size.columns
        << 'x' << size.rows << '\n'
        << terminal.text();
  }
  expect_end_by_key(terminal);
}

TEST(Play, TakesNoPartOfAnEscapeSequenceForAKey) {
  const SceneFile scene(kThreeBalls);
  for (const char* const term : {"TERM=xterm-256color", "TERM=screen", "TERM=linux"}) {
    Terminal::Settings settings;
    settings.environment = {term};
    Terminal terminal({scene.path()}, settings);
    ASSERT_TRUE(terminal.wait_for(" 3 balls")) << terminal.text();
    // Ctrl-Up in its forms, Alt-x, F1 to F5, Shift-Tab, mouse reports of old terminals, an answer
    // of the terminal, a key beyond ASCII.
    terminal.type(
        "\x1B[1;5A\x1BO5A\x1B[5A\x1B[[A\x1BOa\x1Bx\x1BOP\x1B[15~\x1B[Z\x1B[M Ax"
        "\x1B]11;rgb:aa/aa/aa\x1B\\\x1BP1$rxA\x1B\\\xC3\xA9\x1B\xC3\xA9");
    terminal.type("\x1B[200~Aaxq\rA\x1B[201~");
    EXPECT_TRUE(terminal.wait_for("pasted text is ignored")) << terminal.text();
    terminal.watch(std::chrono::milliseconds{300}, [] {});
    EXPECT_TRUE(terminal.shows(" 3 balls")) << terminal.text();
    terminal.type("a");
    EXPECT_TRUE(terminal.wait_for(" 4 balls")) << terminal.text();
    EXPECT_TRUE(terminal.mode_on("2004"));
  }
}

TEST(Play, ShowsColoursOnlyWhereTheyAreWanted) {
  const SceneFile scene(kThreeBalls);
  const std::string color = "38;5;";
  {
    Terminal terminal({scene.path()});
    ASSERT_TRUE(terminal.wait_for("fps"));
    EXPECT_NE(terminal.output().find(color), std::string::npos);
  }
  {
    Terminal terminal({"--no-color", scene.path()});
    ASSERT_TRUE(terminal.wait_for("fps"));
    EXPECT_EQ(terminal.output().find(color), std::string::npos);
  }
  Terminal::Settings refused;
  refused.environment.emplace_back("NO_COLOR=1");
  Terminal terminal({scene.path()}, refused);
  ASSERT_TRUE(terminal.wait_for("fps"));
  EXPECT_EQ(terminal.output().find(color), std::string::npos);
}

TEST(Play, WritesPlainAsciiWhereverItRuns) {
  std::string named = kThreeBalls;
  named.replace(named.find("three"), 5, "d\xC3\xA9j\xC3\xA0");
  const SceneFile scene(named);
  for (const char* const language : {"LANG=C", "LANG=C.UTF-8"}) {
    Terminal::Settings settings;
    settings.environment = {"TERM=xterm", language};
    Terminal terminal({scene.path()}, settings);
    ASSERT_TRUE(terminal.wait_for("d?j?")) << terminal.text();
    terminal.type("q");
    EXPECT_EQ(terminal.wait_for_end(), 0);
    const auto left = terminal.output().find("\x1B[?1049l");
    ASSERT_NE(left, std::string::npos);
    for (const char byte : terminal.output().substr(0, left)) EXPECT_GE(byte, 0);
  }
}

}  // namespace
}  // namespace carom::test::play_test
