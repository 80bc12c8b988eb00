// `carom accuracy --plot`: a drawing by gnuplot where it is installed, a clear line where it is
// not.
#include <gtest/gtest.h>

#include <filesystem>

#include "support/process.hpp"

namespace carom::drawing_test {
namespace {

namespace fs = std::filesystem;
using support::Outcome;
using Names = std::vector<std::string>;

class Drawing : public testing::Test {
 protected:
  Drawing() {
    support::write_file(folder_ / "scene.json", R"({
      "name": "one ball flies", "box": {"width": 20, "height": 10}, "effects": {"walls": {}},
      "balls": [{"position": [3, 5], "velocity": [1, 0], "radius": 0.5}], "duration": 0.25})");
    fs::create_directory(folder_ / "bin");
  }

  /// With no other program to be found than those in the folder bin.
  Outcome plot(const std::string& file) {
    return support::run({"/usr/bin/env", "PATH=" + (folder_ / "bin").string(), CAROM_PROGRAM,
                         "accuracy", "scene.json", "--quiet", "--plot", file},
                        {folder_.path(), ""});
  }

  /// A program of that name which does what the shell is told.
  void install_gnuplot(const std::string& commands) {
    const fs::path program = folder_ / "bin" / "gnuplot";
    support::write_file(program, "#!/bin/sh\n" + commands + "\n");
    fs::permissions(program, fs::perms::owner_all);
  }

  support::TemporaryFolder folder_;
};

TEST_F(Drawing, WithoutGnuplotIsRefusedBeforeAnythingRuns) {
  const Outcome outcome = plot("costs.svg");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err,
            "carom: --plot: gnuplot draws it and is not installed; on Debian: "
            "apt-get install gnuplot-nox\n");
  EXPECT_EQ(support::names_in(folder_.path()), (Names{"bin", "scene.json"}));
}

TEST_F(Drawing, IsWhatGnuplotMakesOfItsScript) {
  install_gnuplot("while read -r line; do echo \"$line\"; done");
  const Outcome outcome = plot("costs.png");
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.status, 0);
  const std::string drawn = support::read_file(folder_ / "costs.png");
  EXPECT_TRUE(drawn.starts_with("set terminal pngcairo")) << drawn;
  EXPECT_NE(drawn.find("plot $series0"), std::string::npos) << drawn;
}

TEST_F(Drawing, OfAGnuplotThatFailsIsNotLeftBehind) {
  install_gnuplot("echo half; exit 3");
  const Outcome outcome = plot("costs.svg");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err, "");
  EXPECT_EQ(support::names_in(folder_.path()), (Names{"bin", "scene.json"}));
}

}  // namespace
}  // namespace carom::drawing_test
