// A run that is killed and started again ends as one that is not.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "support/process.hpp"

namespace carom::checkpoint_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using support::Outcome;
using support::TemporaryFolder;

std::string scene(const std::string& more) {
  return R"({"name": "long", "box": {"width": 10, "height": 8, "periodic": ["x"]},
    "effects": {"collisions": {"restitution": 1}, "walls": {"restitution": 1})" +
         more + R"(,
    "fill": [{"count": 40, "radius": 0.3, "temperature": 2}], "seed": 3, "duration": 40,
    "script": [{"at": 1, "command": "add", "ball": {"position": [0.011, 0.011], "radius": 0.01}},
               {"at": 2, "command": "remove", "ball": 0},
               {"at": 37, "command": "set", "effects": {"walls": {"restitution": 0.9}}},
               {"at": 38, "command": "add",
                "ball": {"position": [5, 7.989], "velocity": [0, 1], "radius": 0.01}}]})";
}

const std::vector<std::string> kGrowing{"dump", "trajectory", "events", "series", "cast"};

std::vector<std::string> words(const std::string& checkpoint) {
  std::vector<std::string> all{CAROM_PROGRAM, "run",      "scene.json", "--quiet", "--every",
                               "3",           "--report", "report",     "--save",  "save"};
  for (const std::string& name : kGrowing) all.insert(all.end(), {"--" + name, name});
  if (!checkpoint.empty()) {
    all.insert(all.end(), {"--checkpoint", checkpoint, "--checkpoint-every", "0.01"});
  }
  return all;
}

/// The report without what is measured in seconds.
Json lasting(const std::string& text) {
  Json report = Json::parse(text);
  for (const char* name : {"wall_seconds", "phases", "effects", "computing", "waiting"}) {
    report.erase(name);
  }
  return report;
}

TEST(Checkpoint, ARunThatWasKilledEndsLikeOneThatWasNot) {
  const std::string losses =
      R"(, "drag": {"rate": 0.01}, "friction": {"balls": 0.2, "walls": 0.3}})";
  for (const std::string& more :
       {std::string("}"), std::string(R"(, "gravity": [0, -1]}, "solver": {"method": "overlap"})"),
        losses, losses + R"(, "solver": {"method": "overlap"})"}) {
    SCOPED_TRACE(more);
    const TemporaryFolder undisturbed;
    support::write_file(undisturbed / "scene.json", scene(more));
    ASSERT_EQ(support::run(words(""), {undisturbed.path(), ""}).status, 0);

    const TemporaryFolder killed;
    support::write_file(killed / "scene.json", scene(more));
    int kills = 0;
    for (int attempt = 0; attempt < 3; ++attempt) {
      support::Running running(words("check"), {killed.path(), ""});
      // Till it has got farther than the attempt before.
      const auto stood = [&] {
        std::error_code ignored;
        return fs::last_write_time(killed / "check", ignored);
      };
      const auto before = stood();
      while (!running.ended() && stood() == before) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      if (running.ended()) break;
      running.signal(SIGKILL);
      (void)running.wait();
      ++kills;
      EXPECT_FALSE(fs::exists(killed / "events"));
      EXPECT_TRUE(fs::exists(killed / "events.unfinished"));
    }
    EXPECT_GT(kills, 0);
    const Outcome outcome = support::run(words("check"), {killed.path(), ""});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    for (const std::string& name : kGrowing) {
      EXPECT_EQ(support::read_file(killed / name), support::read_file(undisturbed / name)) << name;
      EXPECT_FALSE(fs::exists(killed / (name + ".unfinished")));
    }
    EXPECT_EQ(support::read_file(killed / "save"), support::read_file(undisturbed / "save"));
    EXPECT_EQ(lasting(support::read_file(killed / "report")),
              lasting(support::read_file(undisturbed / "report")));
    EXPECT_FALSE(fs::exists(killed / "check"));
  }
}

TEST(Checkpoint, OfAnotherRunIsRefused) {
  const TemporaryFolder folder;
  support::write_file(folder / "scene.json", scene("}"));
  support::Running running(words("check"), {folder.path(), ""});
  while (!running.ended() && !fs::exists(folder / "check")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  running.signal(SIGKILL);
  (void)running.wait();
  std::vector<std::string> other = words("check");
  other.insert(other.end(), {"--seed", "4"});
  const Outcome outcome = support::run(other, {folder.path(), ""});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("is of another run"), std::string::npos) << outcome.err;
  support::write_file(folder / "check", "something else");
  const Outcome damaged = support::run(words("check"), {folder.path(), ""});
  EXPECT_EQ(damaged.status, 2);
  EXPECT_EQ(support::read_file(folder / "check"), "something else");
}

}  // namespace
}  // namespace carom::checkpoint_test
