// An interrupt ends a study of accuracy with the table of what is done.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "support/process.hpp"

namespace carom::accuracy_interrupt_test {
namespace {

using support::Outcome;

TEST(AccuracyInterrupt, PrintsWhatIsDoneAndWritesNoFile) {
  const support::TemporaryFolder folder;
  // Its first runs take milliseconds, all of them far longer than the test waits.
  const std::filesystem::path scene =
      std::filesystem::path(CAROM_SOURCE_DIR) / "scenes/orbits.json";
  support::Running running({CAROM_PROGRAM, "accuracy", scene.string(), "--time", "40", "--share",
                            "20", "--json", (folder / "study.json").string()},
                           {folder.path(), ""});
  std::this_thread::sleep_for(std::chrono::seconds(2));
  running.signal(SIGINT);
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.status, 128 + SIGINT);
  EXPECT_NE(outcome.err.find("carom: stopped with "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("no file is written"), std::string::npos) << outcome.err;
  const bool none = outcome.err.find("stopped with 0 of") != std::string::npos;
  EXPECT_EQ(outcome.out.find("reference: event in steps of") == std::string::npos, none)
      << outcome.out;
  EXPECT_EQ(support::names_in(folder.path()), std::vector<std::string>{});
}

}  // namespace
}  // namespace carom::accuracy_interrupt_test
