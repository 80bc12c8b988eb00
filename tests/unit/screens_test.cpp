// Whole screens as text, as they were once looked at and found right: screens/NAME.txt.
//
// CAROM_SCREENS=1 writes them; look at every one that changes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <regex>
#include <string>

#include "carom/scene_file.hpp"
#include "support/process.hpp"
#include "unit/stage.hpp"
#include "view/player.hpp"

namespace carom {

void PrintTo(const UserInterface::Size& size, std::ostream* out) {
  *out << size.columns << 'x' << size.rows;
}

}  // namespace carom

namespace carom::screens_test {
namespace {

/// Large balls, some fixed, one side periodic; two workers.
Scene scene() {
  return parse_scene(R"({"name": "screens", "box": {"width": 20, "height": 10, "periodic": ["x"]},
    "effects": {"walls": {"restitution": 1}, "collisions": {"restitution": 1},
                "gravity": [0, -1]},
    "balls": [{"position": [3, 6], "velocity": [3, 1], "radius": 1},
              {"position": [8, 3], "velocity": [-2, 2], "radius": 0.8},
              {"position": [12, 7], "velocity": [-3, -1], "radius": 1.2, "mass": 2},
              {"position": [16, 4], "velocity": [1, 3], "radius": 0.5},
              {"position": [18.5, 8], "velocity": [4, 0], "radius": 0.6},
              {"position": [10, 1.5], "radius": 1, "fixed": true},
              {"position": [5, 9], "radius": 0.15, "velocity": [1, -2]}],
    "solver": {"method": "event"}, "workers": 2})",
                     "screens");
}

/// Without what rounding decides.
std::string without_rounding(std::string text) {
  for (const char* const words : {"error", "overlap", "distance"})
    text = std::regex_replace(text, std::regex(std::string(words) + " [^|\n]*"), words);
  return std::regex_replace(text, std::regex("\\[[#.]+\\]"), "[]");
}

struct Screen {
  std::string name;
  std::string keys;
};

class Screens : public testing::TestWithParam<UserInterface::Size> {};

TEST_P(Screens, AreThoseThatWereLookedAt) {
  const Screen screens[] = {{"plain", ""}, {"drawing", "zvN"},         {"instruments", "h"},
                            {"cost", "E"}, {"instruments-cost", "hE"}, {"help", "?"}};
  for (const Screen& each : screens) {
    Stage stage;
    const UserInterface::Size size = GetParam();
    stage.resize(0.01, size);
    stage.keys(0.1, each.keys);
    stage.key(2.52, 'p');  // the notice of a key is over by then
    stage.key(6, 'q');
    Player(scene(), stage).play();
    const std::string shown = without_rounding(stage.at(2.51).text);
    const std::string file = fmt::format(CAROM_SOURCE_DIR "/tests/unit/screens/{}-{}x{}.txt",
                                         each.name, size.columns, size.rows);
    if (std::getenv("CAROM_SCREENS") != nullptr) support::write_file(file, shown);
    ASSERT_TRUE(std::filesystem::exists(file)) << file;
    EXPECT_EQ(shown, support::read_file(file)) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Screens,
                         testing::Values(UserInterface::Size{80, 24}, UserInterface::Size{120, 40},
                                         UserInterface::Size{200, 60}),
                         [](const auto& test) {
                           return fmt::format("{}x{}", test.param.columns, test.param.rows);
                         });

}  // namespace
}  // namespace carom::screens_test
