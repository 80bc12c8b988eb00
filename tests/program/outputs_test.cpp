// What a run writes along the way: the texts themselves, and their sums against its report and
// against theory.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/process.hpp"

namespace carom {
namespace {

using support::read_file;
using support::TemporaryFolder;
using Json = nlohmann::json;
using Row = std::map<std::string, std::string>;

/// A lossy, rubbing gas; a ball comes and the first one goes.
std::string lossy(const std::string& more = "") {
  return R"({"name": "box", "box": {"width": 10, "height": 8},
    "effects": {"collisions": {"restitution": 0.9}, "walls": {"restitution": 0.8},
                "friction": {"balls": 0.2, "walls": 0.3})" +
         more + R"(},
    "fill": [{"count": 30, "radius": 0.3, "temperature": 2}], "seed": 3, "duration": 3,
    "script": [{"at": 1, "command": "add", "ball": {"position": [0.011, 0.011], "radius": 0.01}},
               {"at": 2, "command": "remove", "ball": 0}]})";
}

std::string periodic_gas(std::size_t count, double radius, double duration) {
  std::ostringstream text;
  text << R"({"name": "gas", "box": {"width": 10, "height": 10, "periodic": ["x", "y"]},
    "effects": {"collisions": {"restitution": 1}}, "solver": {"method": "event"},
    "fill": [{"count": )"
       << count << R"(, "radius": )" << radius << R"(, "temperature": 1}],
    "seed": 11, "frame_rate": 2, "duration": )"
       << duration << "}";
  return text.str();
}

/// A run in a folder of its own; every file that there is has its option's name.
class Written {
 public:
  Written(const std::string& scene, const std::vector<std::string>& outputs,
          const std::vector<std::string>& more = {}) {
    support::write_file(folder_ / "scene.json", scene);
    std::vector<std::string> words{CAROM_PROGRAM, "run",      (folder_ / "scene.json").string(),
                                   "--quiet",     "--report", path("report")};
    for (const std::string& name : outputs) {
      words.push_back("--" + name);
      words.push_back(path(name));
    }
    words.insert(words.end(), more.begin(), more.end());
    const support::Outcome outcome = support::run(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }

  [[nodiscard]] std::string text(const std::string& name) const {
    return read_file(folder_ / name);
  }
  [[nodiscard]] Json report() const { return Json::parse(text("report")); }
  [[nodiscard]] std::vector<Row> table(const std::string& name) const {
    std::istringstream lines(text(name));
    const auto cells = [](const std::string& line) {
      std::vector<std::string> result(1);
      for (const char c : line) {
        if (c == ',') {
          result.emplace_back();
        } else {
          result.back() += c;
        }
      }
      return result;
    };
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> names = cells(line);
    std::vector<Row> rows;
    while (std::getline(lines, line)) {
      const std::vector<std::string> values = cells(line);
      EXPECT_EQ(values.size(), names.size()) << line;
      Row& row = rows.emplace_back();
      for (std::size_t k = 0; k < names.size(); ++k) row[names[k]] = values.at(k);
    }
    return rows;
  }

 private:
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }

  TemporaryFolder folder_;
};

double number(const Row& row, const char* name) {
  return std::stod(row.at(name));
}

const char* const kOverlap = R"(}, "solver": {"method": "overlap")";

// The three methods of computing: event, overlap, and event with attraction.
std::vector<std::string> lossy_scenes() {
  return {lossy(), lossy(kOverlap), lossy(R"(, "attraction": {"strength": 0.01, "softening": 1})")};
}

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

/// The mean of a column and its standard error, from means over blocks.
std::pair<double, double> mean_and_error(const std::vector<Row>& rows, const char* name,
                                         std::size_t from) {
  constexpr std::size_t kBlocks = 20;
  const std::size_t length = (rows.size() - from) / kBlocks;
  std::vector<double> blocks(kBlocks, 0);
  for (std::size_t b = 0; b < kBlocks; ++b) {
    for (std::size_t k = 0; k < length; ++k) blocks[b] += number(rows[from + b * length + k], name);
    blocks[b] /= static_cast<double>(length);
  }
  double mean = 0;
  for (const double block : blocks) mean += block / kBlocks;
  double squares = 0;
  for (const double block : blocks) squares += (block - mean) * (block - mean);
  return {mean, std::sqrt(squares / (kBlocks - 1) / kBlocks)};
}

// Kolafa and Rottner, Molecular Physics 104 (2006) 3435.
TEST(Series, ZOfThePeriodicFluidIsTheKnownOne) {
  struct Known {
    double packing;
    double Z;
  };
  for (const Known& known : {Known{.314159, 2.1514393}, Known{.471239, 3.663691}}) {
    constexpr std::size_t kBalls = 400;
    const double radius = std::sqrt(known.packing * 100 / kBalls / 3.14159265358979);
    const Written run(periodic_gas(kBalls, radius, 60), {"series"});
    const auto rows = run.table("series");
    const auto [Z, error] = mean_and_error(rows, "Z", 21);
    EXPECT_LT(error, 0.01 * known.Z);
    EXPECT_NEAR(Z, known.Z, 3 * error + known.Z / kBalls);
    // E = (N - 1) k T without net flow.
    const Row& last = rows.back();
    EXPECT_NEAR(number(last, "temperature"), number(last, "kinetic") / (kBalls - 1), 1e-12);
    EXPECT_NEAR(number(last, "pressure") * 100 / kBalls / number(last, "temperature"),
                number(last, "Z"), 1e-12);
  }
}

// The ideal gas between walls: the centres have the box less the radii.
TEST(Series, ThePressureOnTheWallsOfADiluteGasIsThatOfTheVirial) {
  const Written run(R"({"box": {"width": 10, "height": 10}, "solver": {"method": "event"},
    "effects": {"collisions": {}, "walls": {}}, "seed": 5, "duration": 400, "frame_rate": 1,
    "fill": [{"count": 100, "radius": 0.01, "temperature": 1}]})",
                    {"series", "events"});
  double push = 0;
  std::size_t hits = 0;
  for (const Row& row : run.table("events")) {
    if (row.at("wall").empty()) continue;
    push += number(row, "impulse");
    ++hits;
  }
  const auto rows = run.table("series");
  const double kT = number(rows.back(), "kinetic") / 100;
  const double side = 10 - 2 * 0.01;
  const double ideal = 100 * kT / (side * side);
  // Hits come nearly at random; the mean square of their impulses is 4/pi of the squared mean.
  const double error = ideal * std::sqrt(1.3 / static_cast<double>(hits));
  EXPECT_LT(error, 0.02 * ideal);
  EXPECT_NEAR(push / (4 * side * 400), ideal, 3 * error);
  const auto [virial, spread] = mean_and_error(rows, "pressure", 1);
  EXPECT_NEAR(virial, 100 * kT / 100, 3 * spread + 0.02);
}

struct Slice {
  double begin;
  double end;
  std::string name;
};

TEST(Trace, NamesItsThreadsAndTheirSlicesNeverOverlap) {
  const Written run(lossy(kOverlap), {"trace"}, {"--workers", "3", "--trace-frames", "40"});
  const Json trace = Json::parse(run.text("trace"));
  EXPECT_EQ(trace["displayTimeUnit"], "ms");
  std::map<int, std::string> names;
  std::map<int, std::vector<Slice>> slices;
  for (const Json& event : trace["traceEvents"]) {
    EXPECT_EQ(event["pid"], 1);
    if (event["ph"] == "M" && event["name"] == "thread_name") {
      names[event["tid"]] = event["args"]["name"];
    } else if (event["ph"] == "X") {
      const double begin = event["ts"];
      slices[event["tid"]].push_back({begin, begin + double(event["dur"]), event["name"]});
    }
  }
  EXPECT_EQ(names, (std::map<int, std::string>{
                       {1, "control"}, {2, "worker 0"}, {3, "worker 1"}, {4, "worker 2"}}));
  ASSERT_EQ(slices.size(), 4U);
  EXPECT_EQ(slices[1].size(), 40U);
  std::set<std::string> seen;
  for (const auto& [thread, row] : slices) {
    double last = 0;
    for (const Slice& slice : row) {
      EXPECT_LE(last, slice.begin);
      EXPECT_LE(slice.begin, slice.end);
      last = slice.end;
      seen.insert(slice.name);
      if (thread == 1) {
        EXPECT_EQ(slice.name, "do_frame");
      }
    }
  }
  EXPECT_EQ(seen, (std::set<std::string>{"do_frame", "wait do_frame", "wall_computation",
                                         "wait wall_computation", "pair_computation",
                                         "wait pair_computation", "wait frame_done"}));
  // A phase is computed while control waits for its frame.
  std::size_t frame = 0;
  for (const Slice& slice : slices[2]) {
    if (slice.name.starts_with("wait")) continue;
    while (frame + 1 < slices[1].size() && slices[1][frame].end < slice.begin) ++frame;
    EXPECT_GE(slice.begin, slices[1][frame].begin);
    EXPECT_LE(slice.end, slices[1][frame].end);
  }
}

TEST(Trace, AddsUpToThePhasesOfTheReport) {
  const Written run(lossy(kOverlap), {"trace"}, {"--workers", "2", "--trace-frames", "1000"});
  std::map<std::string, double> spent;  // of worker 0, microseconds
  double frames = 0;
  const Json trace = Json::parse(run.text("trace"));
  for (const Json& event : trace["traceEvents"]) {
    if (event["ph"] != "X") continue;
    if (event["tid"] == 1) frames += double(event["dur"]);
    if (event["tid"] == 2) spent[event["name"]] += double(event["dur"]);
  }
  double phases = 0;
  const Json report = run.report();
  for (const auto& [name, seconds] : report["phases"].items()) {
    const double all = double(seconds) * 1e6;
    phases += all;
    // A phase lasts from before the first worker begins until the last one has arrived.
    EXPECT_GT(spent[name], 0) << name;
    EXPECT_LE(spent[name], all * (1 + 1e-9) + 1) << name;
  }
  EXPECT_LE(phases, frames * (1 + 1e-9) + 1);
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
}  // namespace carom
