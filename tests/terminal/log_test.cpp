// What play writes of a session: the log, which a run repeats, and the recording.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "scenes.hpp"
#include "support/process.hpp"
#include "support/vterm_screen.hpp"
#include "terminal.hpp"

namespace carom::test::log_test {
namespace {

using Json = nlohmann::json;

/// The rows of a terminal without the blanks that end them.
std::string trimmed(const std::string& text) {
  std::istringstream lines(text);
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    line.erase(line.find_last_not_of(' ') + 1);
    all += line + '\n';
  }
  return all;
}

TEST(Log, ARunOfItHasTheImpactsAndTheTimeOfTheSession) {
  const support::TemporaryFolder folder;
  const SceneFile scene(kThreeBalls);
  const std::string log = (folder / "log.json").string();
  Terminal terminal({"play", scene.path(), "--log", log});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  for (const auto& [key, answer] : {std::pair("a", "added a ball"),
                                    {"[", "step 1/480 s"},
                                    {"g", "gravity off"},
                                    {"p", "paused"},
                                    {".", "one frame"},
                                    {"x", "removed the newest ball"},
                                    {"p", "running"}}) {
    terminal.type(key);
    ASSERT_TRUE(terminal.wait_for(answer)) << terminal.text();
  }
  EXPECT_FALSE(std::filesystem::exists(log)) << "it is written whole, at the end";
  terminal.type("q");
  EXPECT_EQ(terminal.wait_for_end(), 0);

  const Json written = Json::parse(support::read_file(log));
  EXPECT_EQ(written["script"].size(), 4U) << written;
  const support::Outcome run = support::run(
      {CAROM_PROGRAM, "run", log, "--quiet", "--report", (folder / "report.json").string()});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json report = Json::parse(support::read_file(folder / "report.json"));
  EXPECT_EQ(report["balls"], 3);
  std::ostringstream impacts;
  impacts << "; " << report["events"]["ball_ball"] << " impacts of balls, "
          << report["events"]["ball_wall"] << " of walls;";
  // The line is longer than the screen is wide.
  std::string told = terminal.text();
  std::erase(told, '\n');
  EXPECT_NE(told.find(impacts.str()), std::string::npos) << impacts.str() << '\n' << told;

  Terminal again({"play", log});
  EXPECT_TRUE(again.wait_for(" 4 balls")) << again.text();
  EXPECT_TRUE(again.wait_for(" 3 balls")) << again.text();
}

TEST(Log, IsWrittenWhenASignalEndsTheSessionAndNotWhenItCrashes) {
  const SceneFile scene(kThreeBalls);
  for (const int signal : {SIGTERM, SIGSEGV}) {
    const support::TemporaryFolder folder;
    Terminal terminal({scene.path(), "--log", (folder / "log.json").string(), "--record",
                       (folder / "cast").string()});
    ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
    terminal.signal(signal);
    (void)terminal.wait_for_end();
    EXPECT_TRUE(terminal.given_back());
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder / "."))
      ++files;
    EXPECT_EQ(files, signal == SIGTERM ? 2U : 0U);
  }
}

TEST(Record, ReplayedShowsWhatTheScreenShowed) {
  const support::TemporaryFolder folder;
  const SceneFile scene(kThreeBalls);
  Terminal terminal({scene.path(), "--record", (folder / "cast").string(), "--glyphs", "blocks"});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  terminal.resize(100, 30);
  ASSERT_TRUE(terminal.wait([](const Terminal& t) {
    return t.row(28).find(" fps") != std::string::npos;
  })) << terminal.text();
  terminal.type("p");
  ASSERT_TRUE(terminal.wait_for("paused: ")) << terminal.text();
  terminal.watch(std::chrono::milliseconds{300}, [] {});
  const std::string last = trimmed(terminal.text());
  terminal.type("q");
  EXPECT_EQ(terminal.wait_for_end(), 0);

  std::istringstream lines(support::read_file(folder / "cast"));
  std::string line;
  std::getline(lines, line);
  const Json header = Json::parse(line);
  EXPECT_EQ(header["version"], 2);
  EXPECT_EQ(header["width"], 80);
  EXPECT_EQ(header["height"], 24);
  EXPECT_EQ(header["title"], "carom: three");
  support::VtermScreen shown(80, 24);
  double time = 0;
  std::size_t resizes = 0;
  std::size_t pictures = 0;
  while (std::getline(lines, line)) {
    const Json event = Json::parse(line);
    EXPECT_GE(double(event[0]), time);
    time = event[0];
    if (event[1] == "r") {
      EXPECT_EQ(event[2], "100x30");
      shown.resize(100, 30);
      ++resizes;
    } else {
      shown.write(event[2]);
      ++pictures;
    }
  }
  EXPECT_EQ(resizes, 1U);
  EXPECT_GT(pictures, 2U);
  EXPECT_GT(time, 0.3) << "the clock of the screen";
  EXPECT_EQ(shown.text(), last);
}

TEST(Record, WhatCannotBeWrittenIsRefusedBeforeTheTerminalIsTouched) {
  const SceneFile scene(kThreeBalls);
  for (const std::string option : {"--log", "--record"}) {
    for (const auto& [file, words] : {std::pair("/no/folder/file", "/no/folder/file"),
                                      {"-", "must be a file: standard output is the screen"}}) {
      Terminal terminal({scene.path(), option, file});
      EXPECT_EQ(terminal.wait_for_end(), 2);
      EXPECT_EQ(terminal.output().find('\x1B'), std::string::npos);
      EXPECT_NE(terminal.output().find("carom: " + option), std::string::npos) << terminal.output();
      EXPECT_NE(terminal.output().find(words), std::string::npos) << terminal.output();
    }
  }
  Terminal both({scene.path(), "--log", "same", "--record", "./same"});
  EXPECT_EQ(both.wait_for_end(), 2);
  EXPECT_NE(both.output().find("--record and --log both write to"), std::string::npos);
}

}  // namespace
}  // namespace carom::test::log_test
