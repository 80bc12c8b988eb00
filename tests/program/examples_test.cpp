// The scripts of scenes/examples do what they say.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "support/process.hpp"

namespace carom::examples_test {
namespace {

const std::string kExamples = CAROM_SOURCE_DIR "/scenes/examples/";

bool is_installed(const std::string& program) {
  return support::run({"/bin/sh", "-c", "command -v " + program}).status == 0;
}

TEST(Examples, TheSpeedsOfAGasAreThoseOfMaxwell) {
  if (!is_installed("python3")) GTEST_SKIP() << "python3 is not installed";
  const support::TemporaryFolder folder;
  const std::string trajectory = (folder / "gas.xyz").string();
  ASSERT_EQ(support::run({CAROM_PROGRAM, "run", CAROM_SOURCE_DIR "/tests/readers/gas.json",
                          "--quiet", "--every", "10", "--trajectory", trajectory})
                .status,
            0);
  const support::Outcome outcome =
      support::run({"/usr/bin/env", "python3", kExamples + "speeds.py", trajectory});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::size_t last = outcome.out.rfind("speed: ");
  ASSERT_NE(last, std::string::npos);
  EXPECT_NEAR(std::stod(outcome.out.substr(last + 7)), std::acos(-1.0) / 4, 0.005);
}

TEST(Examples, TheTemperatureIsDrawn) {
  if (!is_installed("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
  const support::TemporaryFolder folder;
  ASSERT_EQ(support::run({CAROM_PROGRAM, "run", CAROM_SOURCE_DIR "/tests/engines/sweep.json",
                          "--quiet", "--series", (folder / "series.csv").string()})
                .status,
            0);
  const support::Outcome outcome =
      support::run({"/usr/bin/env", "gnuplot", kExamples + "temperature.gp"}, {folder.path(), ""});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(support::read_file(folder / "temperature.svg").find("</svg>"), std::string::npos);
}

TEST(Examples, TheEquationOfStateIsThatOfTheory) {
  if (!is_installed("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
  const support::TemporaryFolder folder;
  const std::string sweep = (folder / "sweep").string();
  const support::Outcome outcome =
      support::run({"/bin/sh", kExamples + "equation_of_state.sh", CAROM_PROGRAM, sweep});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(support::read_file(sweep + "/equation_of_state.svg").find("</svg>"), std::string::npos);
  std::istringstream lines(support::read_file(sweep + "/summary.csv"));
  std::string line;
  std::getline(lines, line);
  std::size_t column = 0;
  for (std::size_t at = 0; !line.substr(at).starts_with("Z_mean"); at = line.find(',', at) + 1) {
    ++column;
  }
  std::size_t points = 0;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string cell;
    std::getline(cells, cell, ',');
    const double packing = 4 * std::stod(cell) * std::stod(cell);
    for (std::size_t k = 0; k < column; ++k) std::getline(cells, cell, ',');
    ++points;
    // Scaled particle theory, right to 2 % up to here; the runs are short.
    if (packing > 0.5) continue;
    const double theory = 1 / ((1 - packing) * (1 - packing));
    EXPECT_NEAR(std::stod(cell), theory, 0.04 * theory) << packing;
  }
  EXPECT_EQ(points, 20U);
}

}  // namespace
}  // namespace carom::examples_test
