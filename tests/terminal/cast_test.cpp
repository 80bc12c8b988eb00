// A cast that a run writes shows what its dump shows.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "support/process.hpp"
#include "support/vterm_screen.hpp"

namespace carom::cast_test {
namespace {

using Json = nlohmann::json;

TEST(Cast, ReplayedShowsTheFramesOfTheDump) {
  const support::TemporaryFolder folder;
  support::write_file(folder / "scene.json", R"({"name": "a \"cast\"",
    "box": {"width": 20, "height": 10}, "frame_rate": 20, "duration": 4,
    "effects": {"walls": {}, "collisions": {}, "gravity": [0, -5]},
    "fill": [{"count": 12, "radius": 0.6, "temperature": 4}],
    "script": [{"at": 1, "command": "pause"}, {"at": 2, "command": "resume"}]})");
  const support::Outcome outcome = support::run(
      {CAROM_PROGRAM, "run", (folder / "scene.json").string(), "--quiet", "--size", "60x17",
       "--cast", (folder / "cast").string(), "--dump", (folder / "dump").string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;

  std::istringstream lines(support::read_file(folder / "cast"));
  std::string line;
  std::getline(lines, line);
  const Json header = Json::parse(line);
  EXPECT_EQ(header["version"], 2);
  EXPECT_EQ(header["width"], 60);
  EXPECT_EQ(header["height"], 17);
  EXPECT_EQ(header["title"], "a \"cast\"");
  std::multimap<double, std::string> output;
  double last = 0;
  std::size_t bytes = 0;
  while (std::getline(lines, line)) {
    const Json event = Json::parse(line);
    ASSERT_EQ(event.size(), 3U);
    EXPECT_EQ(event[1], "o");
    EXPECT_GE(double(event[0]), last);
    last = event[0];
    bytes += std::string(event[2]).size();
    output.emplace(last, event[2]);
  }

  support::VtermScreen shown(60, 17);
  auto next = output.begin();
  std::istringstream dump(support::read_file(folder / "dump"));
  std::size_t frames = 0;
  std::getline(dump, line);
  while (dump) {
    const double clock = std::stod(line.substr(8)) / 20;
    std::string picture;
    while (std::getline(dump, line) && !line.starts_with("# frame")) picture += line + '\n';
    for (; next != output.end() && next->first <= clock + 1e-6; ++next) shown.write(next->second);
    EXPECT_EQ(shown.text(), picture) << "frame " << frames;
    ++frames;
  }
  EXPECT_EQ(frames, 101U);
  EXPECT_EQ(next, output.end());
  EXPECT_LT(bytes, frames * 60 * 17 / 4);  // of cells that have changed
}

}  // namespace
}  // namespace carom::cast_test
