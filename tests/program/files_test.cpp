// Files of a run as their user meets them: written whole or not at all.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "support/process.hpp"

namespace carom::files_test {
namespace {

namespace fs = std::filesystem;
using support::Outcome;
using support::TemporaryFolder;
using Names = std::vector<std::string>;

class Files : public testing::Test {
 protected:
  Files() {
    support::write_file(folder_ / "scene.json", R"({
      "name": "one ball flies", "box": {"width": 20, "height": 10}, "effects": {"walls": {}},
      "balls": [{"position": [3, 5], "velocity": [1, 0], "radius": 0.5}]})");
  }

  Outcome run(std::vector<std::string> words) {
    words.insert(words.begin(), {CAROM_PROGRAM, "run", "scene.json"});
    return support::run(words, {folder_.path(), ""});
  }

  /// `carom` stands for the program.
  Outcome shell(const std::string& line) {
    return support::run({"/bin/sh", "-c", "carom() { " CAROM_PROGRAM " \"$@\"; }; " + line},
                        {folder_.path(), ""});
  }

  [[nodiscard]] std::string text(const std::string& name) const {
    return support::read_file(folder_ / name);
  }

  /// A run that would go on for years, stopped by a signal as soon as it has begun.
  Outcome signalled(int number) {
    support::Running running({CAROM_PROGRAM, "run", "scene.json", "--time", "1e9", "--dump", "dump",
                              "--report", "report", "--save", "save"},
                             {folder_.path(), ""});
    while (support::names_in(folder_.path()).size() < kNamesWhileRunning && !running.ended()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    running.signal(number);
    return running.wait();
  }

  static constexpr std::size_t kNamesWhileRunning = 5;  // scene, old dump, three temporary files
  TemporaryFolder folder_;
};

TEST_F(Files, AFileInNoFolderIsFoundBeforeTheRunAndNothingIsLeft) {
  support::write_file(folder_ / "dump", "old");
  const Outcome outcome = run({"--time", "1e9", "--dump", "dump", "--report", "no/where"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "carom: --report: no/where: No such file or directory\n");
  EXPECT_EQ(text("dump"), "old");
  EXPECT_EQ(support::names_in(folder_.path()), (Names{"dump", "scene.json"}));
}

TEST_F(Files, ASignalEndsTheRunAndLeavesTheOldFileAndNoTemporaryOnes) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    support::write_file(folder_ / "dump", "old");
    const Outcome outcome = signalled(number);
    EXPECT_EQ(outcome.status, 128 + number);
    EXPECT_EQ(text("dump"), "old");
    EXPECT_EQ(support::names_in(folder_.path()), (Names{"dump", "scene.json"}));
  }
}

TEST_F(Files, AFileThatIsReplacedKeepsItsPermissionsAndANewOneGetsTheUsualOnes) {
  support::write_file(folder_ / "old", "old");
  fs::permissions(folder_ / "old", static_cast<fs::perms>(0604));
  const Outcome outcome =
      shell("umask 027; carom run scene.json --frames 0 --report old --dump new");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(text("old"), "old");
  EXPECT_EQ(fs::status(folder_ / "old").permissions(), static_cast<fs::perms>(0604));
  EXPECT_EQ(fs::status(folder_ / "new").permissions(), static_cast<fs::perms>(0640));
}

TEST_F(Files, ASymbolicLinkStaysAndItsTargetIsReplaced) {
  support::write_file(folder_ / "target", "old");
  fs::create_symlink("target", folder_ / "link");
  ASSERT_EQ(run({"--frames", "0", "--report", "link"}).status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(text("target").front(), '{');
}

TEST_F(Files, DevicesAreWrittenThrough) {
  EXPECT_EQ(run({"--frames", "0", "--report", "/dev/null", "--dump", "/dev/null"}).status, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const Outcome full = run({"--frames", "0", "--report", "/dev/full"});
  EXPECT_EQ(full.status, 1);
  EXPECT_EQ(full.err, "carom: --report: /dev/full: No space left on device\n");
}

TEST_F(Files, APipeIsWrittenThrough) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  const Outcome outcome =
      shell("cat pipe & carom run scene.json --frames 0 --quiet --report pipe; wait");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, 1), "{");
  EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
}

TEST_F(Files, StandardOutputByItsDeviceIsStandardOutput) {
  const Outcome outcome =
      shell("carom run scene.json --frames 0 --report /dev/stdout --quiet > file");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(text("file").front(), '{');
  EXPECT_EQ(run({"--dump", "-", "--report", "/dev/stdout"}).status, 2);
}

TEST_F(Files, ASummaryThatFindsStandardOutputClosedDoesNotLandInAFile) {
  const Outcome outcome = shell("carom run scene.json --frames 0 --dump dump >&-");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "carom: standard output: Bad file descriptor\n");
  EXPECT_EQ(text("dump").find("workers"), std::string::npos);
}

TEST_F(Files, AFullStandardOutputIsAFailure) {
  const Outcome run = shell("carom run scene.json --frames 0 > /dev/full");
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "carom: standard output: No space left on device\n");
  EXPECT_EQ(shell("carom --help > /dev/full").status, 1);
}

TEST_F(Files, AReaderThatLeavesEndsTheRunQuietlyAndLeavesNothingBehind) {
  const Outcome outcome =
      shell("carom run scene.json --time 1e9 --dump - --report report | head -n 1");
  EXPECT_EQ(outcome.out, "# frame 0 time 0\n");
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(support::names_in(folder_.path()), (Names{"scene.json"}));
}

TEST_F(Files, TheSummaryGoesToStandardErrorWhereAFileTakesStandardOutput) {
  const Outcome outcome = run({"--frames", "0", "--report", "-"});
  EXPECT_EQ(outcome.out.substr(outcome.out.size() - 2), "}\n");
  EXPECT_EQ(outcome.err.substr(0, outcome.err.find('\n')), "one ball flies");
}

TEST_F(Files, TwoNamesOfOneFileAreRefused) {
  for (const char* link : {"touch a; ln -s a b", "touch a; ln a b", "ln -s a b", "ln -s $PWD/a b",
                           "mkdir d; ln -s d e; ln -s e/a b; ln -s ../a d/a"}) {
    const Outcome outcome = shell(std::string("rm -rf a b d e; ") + link +
                                  "; carom run scene.json --quiet --time 0 --save a --report b");
    EXPECT_EQ(outcome.status, 2) << link;
    EXPECT_EQ(outcome.err, "carom: --report and --save both write to 'a': give them two files\n");
  }
  EXPECT_EQ(shell("carom run scene.json --time 0 --save - --report /dev/fd/1").status, 2);
  EXPECT_EQ(shell("carom run scene.json --time 0 --save a --report - >a").status, 2);
  EXPECT_EQ(shell("carom run scene.json --time 0 --save /dev/stderr --report /dev/stderr").status,
            2);
  EXPECT_EQ(shell("carom run scene.json --time 0 --quiet --save a --report /dev/null").status, 0);
}

TEST_F(Files, ALinkThatLeadsToNoFileStaysALink) {
  EXPECT_EQ(shell("ln -s target link; carom run scene.json --time 0 --quiet --save link").status,
            0);
  EXPECT_TRUE(fs::is_symlink(folder_.path() / "link"));
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder_.path() / "target")));
}

TEST_F(Files, ANameMayHave255Bytes) {
  std::string accented;
  for (int i = 0; i < 127; ++i) accented += "\u00e4";
  for (const std::string& name : {std::string(255, 'x'), accented + "x"}) {
    ASSERT_EQ(name.size(), 255U);
    const Outcome outcome = run({"--time", "0", "--quiet", "--save", name});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(text(name), "");
  }
  const Outcome longer = run({"--time", "0", "--quiet", "--save", std::string(256, 'x')});
  EXPECT_EQ(longer.status, 1);
  EXPECT_NE(longer.err.find("File name too long"), std::string::npos) << longer.err;
}

TEST_F(Files, ALongErrorIsOneShortLine) {
  const std::string key(100000, 'k');
  support::write_file(folder_ / "long.json",
                      R"({"box": {"width": 20, "height": 10}, ")" + key + "\": 1}");
  for (const char* command : {"run", "check"}) {
    const Outcome outcome = shell(std::string("carom ") + command + " long.json");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_LT(outcome.err.size(), 330U);
    EXPECT_TRUE(outcome.err.starts_with("carom: long.json: /kkk")) << outcome.err;
    EXPECT_TRUE(
        outcome.err.ends_with("is not a key of a scene, the nearest known one is \"workers\"\n"))
        << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  }
}

TEST_F(Files, LackOfMemoryIsSaid) {
  support::write_file(folder_ / "large.json", R"({"box": {"width": 1e5, "height": 1e5},
    "fill": [{"count": 5000000, "radius": 0.5}]})");
  const Outcome outcome = shell("ulimit -v 300000; carom run large.json --time 0 --workers 1");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err,
            "carom: not enough memory: make the scene smaller, or allow the program more\n");
}

TEST_F(Files, TheFolderOfScenesCanBeCheckedWhole) {
  const Outcome outcome = shell("carom check " CAROM_SOURCE_DIR "/scenes/*.json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("scene.schema.json: the schema of scenes, not a scene\n"),
            std::string::npos);
}

}  // namespace
}  // namespace carom::files_test
