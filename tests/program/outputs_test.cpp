// What a run writes along the way, whatever the workers, and what it refuses to write.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "program/written.hpp"
#include "support/process.hpp"

namespace carom::outputs_test {
namespace {

using support::TemporaryFolder;
using test::lossy;
using test::lossy_scenes;
using test::Row;
using test::Written;

TEST(Outputs, AreTheSameBytesForAnyWorkers) {
  const std::vector<std::string> names{"trajectory", "events", "series", "cast", "dump"};
  std::vector<std::string> scenes = lossy_scenes();
  scenes.push_back(lossy(R"(, "gravity": [0, -3])"));
  for (const std::string& scene : scenes) {
    const Written one(scene, names, {"--workers", "1"});
    const Written three(scene, names, {"--workers", "3"});
    for (const std::string& name : names) EXPECT_EQ(one.text(name), three.text(name)) << name;
  }
}

TEST(Outputs, AreWrittenAtTheFramesThatEveryLeaves) {
  const Written run(lossy(), {"trajectory", "series"}, {"--every", "30"});
  std::vector<std::string> frames;
  for (const Row& row : run.table("series")) frames.push_back(row.at("frame"));
  EXPECT_EQ(frames, (std::vector<std::string>{"0", "30", "60", "90"}));
}

TEST(Outputs, ARunRefusesWhatItCannotWriteBeforeItRuns) {
  const TemporaryFolder folder;
  support::write_file(folder / "scene.json", lossy());
  const auto refused = [&](const std::vector<std::string>& more, const std::string& words) {
    std::vector<std::string> all{CAROM_PROGRAM, "run", (folder / "scene.json").string()};
    all.insert(all.end(), more.begin(), more.end());
    const support::Outcome outcome = support::run(all, {folder.path(), ""});
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(support::names_in(folder.path()), (std::vector<std::string>{"scene.json"}));
  };
  refused({"--events", "-", "--series", "-"}, "--events and --series");
  refused({"--trajectory", "x", "--cast", "x"}, "--trajectory and --cast");
  refused({"--events", "nowhere/x"}, "--events: nowhere/x");
  refused({"--trace", "x", "--trace-frames", "0"}, "--trace-frames");
}

TEST(Report, LeavesTheStateOutWhereAsked) {
  const Written run(lossy(), {}, {"--no-state"});
  EXPECT_FALSE(run.report().contains("state"));
  EXPECT_TRUE(run.report().contains("state_hash"));
}

}  // namespace
}  // namespace carom::outputs_test
