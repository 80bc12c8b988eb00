// The trajectory that a run writes, against its report.
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "program/written.hpp"

namespace carom::trajectory_test {
namespace {

using test::Json;
using test::lossy;
using test::Written;

TEST(Trajectory, IsExtendedXyzWithLastingNumbersOfTheBalls) {
  const Written run(lossy(), {"trajectory"}, {"--every", "45"});
  std::istringstream lines(run.text("trajectory"));
  std::vector<std::set<std::string>> ids;
  std::vector<std::string> heads;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t count = std::stoul(line);
    std::getline(lines, line);
    heads.push_back(line.substr(0, line.find(" state_hash")));
    auto& numbers = ids.emplace_back();
    for (std::size_t k = 0; k < count; ++k) {
      std::getline(lines, line);
      std::istringstream words(line);
      std::vector<std::string> row{std::istream_iterator<std::string>(words), {}};
      ASSERT_EQ(row.size(), 11U) << line;
      EXPECT_EQ(row[0], "o");
      EXPECT_EQ(row[3], "0");
      numbers.insert(row[4]);
    }
  }
  EXPECT_EQ(heads[0],
            "Lattice=\"10 0 0 0 8 0 0 0 0.6\" Origin=\"0 0 -0.3\" pbc=\"F F F\" "
            "Properties=species:S:1:pos:R:3:id:I:1:radius:R:1:mass:R:1:velo:R:3:spin:R:1 "
            "Time=0 frame=0 scene=\"box\" seed=3");
  ASSERT_EQ(ids.size(), 3U);
  EXPECT_EQ(ids[0].size(), 30U);
  EXPECT_EQ(ids[1].count("30"), 1U);  // at 1.5: it was added
  EXPECT_EQ(ids[1].count("0"), 1U);
  EXPECT_EQ(ids[2].count("0"), 0U);  // at 3: it was removed, and the others keep their numbers
  EXPECT_EQ(ids[2].count("29"), 1U);
  EXPECT_EQ(ids[2].size(), 30U);
}

TEST(Trajectory, EndsInTheStateOfTheReport) {
  const Written run(lossy(), {"trajectory"});
  const Json report = run.report();
  const std::string text = run.text("trajectory");
  const std::size_t last = text.rfind("state_hash=\"");
  EXPECT_EQ(text.substr(last + 12, 16), report["state_hash"]);
  std::istringstream lines(text.substr(text.find('\n', last) + 1));
  for (const Json& ball : report["state"]) {
    std::string species;
    double x = 0;
    double y = 0;
    double z = 0;
    std::size_t id = 0;
    double radius = 0;
    double mass = 0;
    double vx = 0;
    lines >> species >> x >> y >> z >> id >> radius >> mass >> vx;
    EXPECT_EQ(x, double(ball["position"][0]));
    EXPECT_EQ(y, double(ball["position"][1]));
    EXPECT_EQ(vx, double(ball["velocity"][0]));
    std::string rest;
    std::getline(lines, rest);
  }
}

}  // namespace
}  // namespace carom::trajectory_test
