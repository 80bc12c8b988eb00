#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

#include "carom/crew.hpp"
#include "scenes.hpp"
#include "steps.hpp"
#include "terminal.hpp"
#include "view/player.hpp"
#include "view/terminal_screen.hpp"

namespace carom::test::refusal_test {
namespace {

/// Each row as it stands, so that words are found across the ends of rows.
std::string flowing(const Terminal& terminal) {
  std::string text = terminal.text();
  std::erase(text, '\n');
  return text;
}

TEST(Refusal, NamesATerminalThatCannotShowMovingBalls) {
  const SceneFile scene(kThreeBalls);
  const std::pair<std::string, std::string> cases[] = {
      {"TERM=dumb", "TERM=dumb cannot move its cursor"},
      {"TERM=", "TERM is not set"},
      {"LANG=C", "TERM is not set"}};
  for (const auto& [setting, words] : cases) {
    Terminal::Settings settings;
    settings.environment = {setting};
    Terminal terminal({scene.path()}, settings);
    EXPECT_EQ(terminal.wait_for_end(), 2);
    EXPECT_NE(flowing(terminal).find("carom: play needs a terminal, and " + words),
              std::string::npos)
        << terminal.text();
    EXPECT_NE(flowing(terminal).find("carom run"), std::string::npos) << terminal.text();
    EXPECT_EQ(terminal.output().find('\x1B'), std::string::npos);
    EXPECT_TRUE(terminal.given_back());
  }
}

TEST(Refusal, TreatsAnUnknownTerminalAsTheUsualOneAndSaysSo) {
  const SceneFile scene(kThreeBalls);
  Terminal::Settings settings;
  settings.environment = {"TERM=no-such-terminal", "LANG=C"};
  Terminal terminal({scene.path()}, settings);
  ASSERT_TRUE(terminal.wait_for(" 3 balls")) << terminal.text();
  expect_end_by_key(terminal);
  EXPECT_NE(flowing(terminal).find(
                "carom: TERM=no-such-terminal is not known here: treated as xterm-256color"),
            std::string::npos)
      << terminal.text();
}

/// Runs `command` in a shell and gives its standard error; puts its exit status into `status`.
std::string errors_of(const std::string& command, int& status) {
  FILE* const pipe = popen(("{ " + command + "; } 2>&1 >/dev/null").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("no shell");
  std::string text;
  std::array<char, 4096> bytes{};
  while (const std::size_t count = fread(bytes.data(), 1, bytes.size(), pipe))
    text.append(bytes.data(), count);
  const int result = pclose(pipe);
  status = WIFEXITED(result) ? WEXITSTATUS(result) : -1;
  return text;
}

TEST(Refusal, PointsToRunWhereThereIsNoTerminal) {
  int status = 0;
  for (const char* const command : {"", " play"}) {
    const std::string error =
        errors_of(std::string(CAROM_PROGRAM) + command + " </dev/null", status);
    EXPECT_EQ(status, 2);
    EXPECT_NE(error.find("standard input is none"), std::string::npos) << error;
    EXPECT_NE(error.find("carom run"), std::string::npos) << error;
    EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << error;
  }
}

TEST(Refusal, TellsABadSceneBeforeItTouchesTheTerminal) {
  const SceneFile scene("{\"balls\": [}");
  Terminal terminal({scene.path()});
  EXPECT_EQ(terminal.wait_for_end(), 2);
  EXPECT_EQ(terminal.output().find('\x1B'), std::string::npos);
  EXPECT_EQ(terminal.output().rfind("carom: ", 0), 0U) << terminal.output();
}

TEST(Failure, InAWorkerGivesTheTerminalBackAndIsTold) {
  Terminal terminal([] {
    try {
      Signals signals;
      TerminalScreen::Options how;
      how.mouse = true;
      TerminalScreen screen(signals, load_terminal_info(), how);
      Canvas canvas(screen.size().columns, screen.size().rows);
      canvas.write(0, 0, "playing", Ink::status);
      screen.show(canvas);
      while (screen.wait_until(screen.now() + std::chrono::seconds{60}).kind != Event::Kind::key) {
      }
      const auto fail = [](Share share) {
        if (share.index == 1) throw std::runtime_error("a worker failed");
      };
      Crew crew(3, {{"wall_computation", fail, [] { return Phase::kFrameDone; }}});
      crew.do_frame();
      return 0;
    } catch (const std::exception& error) {
      dprintf(STDERR_FILENO, "carom: %s\n", error.what());
      return 1;
    }
  });
  ASSERT_TRUE(terminal.wait_for("playing")) << terminal.text();
  EXPECT_TRUE(terminal.alternate_screen());
  EXPECT_TRUE(terminal.mode_on("1002"));
  terminal.type("x");
  EXPECT_EQ(terminal.wait_for_end(), 1);
  EXPECT_TRUE(terminal.given_back());
  EXPECT_TRUE(terminal.shows("carom: a worker failed")) << terminal.text();
}

}  // namespace
}  // namespace carom::test::refusal_test
