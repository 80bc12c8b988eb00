// The impacts that a run writes: against its report, and what must hold for each.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "program/written.hpp"

namespace carom::events_test {
namespace {

using test::Json;
using test::kOverlap;
using test::lossy;
using test::lossy_scenes;
using test::number;
using test::Row;
using test::Written;

TEST(Events, AreAsManyAsTheReportCounts) {
  for (const std::string& scene : lossy_scenes()) {
    const Written run(scene, {"events"});
    std::uint64_t balls = 0;
    std::uint64_t walls = 0;
    for (const Row& row : run.table("events")) {
      const std::string& kind = row.at("kind");
      if (kind == "ball" || kind == "joint") balls += row.at("b").empty() ? 0 : 1;
      if (kind == "wall" || kind == "joint") walls += row.at("wall").empty() ? 0 : 1;
    }
    EXPECT_GT(balls, 20U);
    EXPECT_EQ(balls, run.report()["events"]["ball_ball"]);
    EXPECT_EQ(walls, run.report()["events"]["ball_wall"]);
  }
}

// Without forces nothing but impacts takes energy, and nothing but walls changes the momentum.
TEST(Events, TellWhatIsLostAndWhatTheWallsGive) {
  for (const std::string& scene : {lossy(), lossy(kOverlap)}) {
    Written run(scene.substr(0, scene.find(",\n    \"script\"")) + "}", {"events"});
    double lost = 0;
    double x = 0;
    double y = 0;
    for (const Row& row : run.table("events")) {
      lost += number(row, "energy_lost");
      if (row.at("wall").empty()) continue;
      // Ball a loses J n + T t with t = (-n_y, n_x).
      x -= number(row, "impulse") * number(row, "nx") -
           number(row, "tangential") * number(row, "ny");
      y -= number(row, "impulse") * number(row, "ny") +
           number(row, "tangential") * number(row, "nx");
    }
    const Json report = run.report();
    const double before = report["energy"]["initial"];
    const double after = report["energy"]["final"];
    EXPECT_GT(lost, before / 10);
    EXPECT_NEAR(lost, before - after, 1e-13 * before);
    EXPECT_NEAR(x,
                double(report["momentum"]["final"][0]) - double(report["momentum"]["initial"][0]),
                1e-12);
    EXPECT_NEAR(y,
                double(report["momentum"]["final"][1]) - double(report["momentum"]["initial"][1]),
                1e-12);
  }
}

TEST(Events, AreInTheOrderOfTimeAndOfTheBallsAndNameThem) {
  const Written run(lossy(), {"events"});
  std::tuple<double, std::size_t> last{-1, 0};
  std::set<std::string> kinds;
  for (const Row& row : run.table("events")) {
    kinds.insert(row.at("kind"));
    const std::tuple now{number(row, "time"), std::stoul(row.at("a"))};
    EXPECT_LE(last, now);
    last = now;
    if (row.at("kind") == "add") {
      EXPECT_EQ(row.at("a"), "30");
      EXPECT_EQ(row.at("time"), "1");
    }
    if (row.at("kind") == "remove") {
      EXPECT_EQ(row.at("a"), "0");
      EXPECT_EQ(row.at("time"), "2");
    }
    if (number(row, "time") > 2) {
      EXPECT_NE(row.at("a"), "0");
    }
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"add", "ball", "remove", "wall"}));
}

// Two balls strike a third at once, and one elsewhere strikes a wall at that time.
TEST(Events, OfOneInstantThatShareABallShareANumber) {
  const Written run(
      R"({"box": {"width": 20, "height": 10}, "effects": {"collisions": {}, "walls": {}},
    "balls": [{"position": [5, 5], "velocity": [1, 0]}, {"position": [10, 5]},
              {"position": [15, 5], "velocity": [-1, 0]}, {"position": [10, 9], "radius": 0.25,
               "velocity": [0, 0.1875]}], "duration": 5})",
      {"events"});
  const auto rows = run.table("events");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].at("kind"), "joint");
  EXPECT_EQ(rows[1].at("kind"), "joint");
  EXPECT_EQ(rows[0].at("event"), rows[1].at("event"));
  EXPECT_EQ(rows[0].at("a") + rows[0].at("b"), "01");
  EXPECT_EQ(rows[1].at("a") + rows[1].at("b"), "12");
  EXPECT_EQ(rows[2].at("kind"), "wall");
  EXPECT_EQ(rows[2].at("wall"), "top");
  EXPECT_NE(rows[2].at("event"), rows[0].at("event"));
  // The outer two turn round, of mass 1 each: the middle one takes nothing in all.
  EXPECT_EQ(rows[0].at("impulse"), "2");
  EXPECT_EQ(rows[1].at("impulse"), "2");
  EXPECT_EQ(rows[0].at("nx"), "1");
}

}  // namespace
}  // namespace carom::events_test
