// The directions of the house: a file includes what is below it and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

#include "support/process.hpp"

namespace carom::layers_test {
namespace {

namespace fs = std::filesystem;

const fs::path kTop = CAROM_SOURCE_DIR;

/// Files whose path from the top begins with `place` may include, besides the standard library and
/// the system, what begins with one of `allowed`.  The first place that fits counts.
struct Layer {
  std::string place;
  std::vector<std::string> allowed;
};

const std::vector<Layer> kLayers{
    {"engine/include/carom/", {"carom/"}},
    {"engine/src/state/", {"carom/", "state/"}},
    {"engine/src/numbers/", {"numbers/"}},
    {"engine/src/geometry/", {"geometry/"}},
    {"engine/src/contact/factor_pattern", {"contact/", "Eigen/"}},
    {"engine/src/contact/cone_guess.cpp", {"contact/", "numbers/", "Eigen/"}},
    {"engine/src/trajectory/", {"numbers/", "trajectory/"}},
    {"engine/src/contact/", {"carom/", "numbers/", "geometry/", "state/", "contact/"}},
    {"engine/src/effects/", {"carom/", "state/", "contact/", "effects/"}},
    {"engine/src/solvers/",
     {"carom/", "numbers/", "geometry/", "trajectory/", "state/", "contact/", "effects/",
      "solvers/", "fmt/"}},
    {"engine/src/crew/",
     {"carom/barrier.hpp", "carom/crew.hpp", "carom/measurements.hpp", "carom/timeline.hpp",
      "crew/", "fmt/"}},
    {"engine/src/fill/", {"carom/", "geometry/", "fill/", "fmt/"}},
    {"engine/src/json/", {"carom/text_sink.hpp", "json/", "fmt/"}},
    {"engine/src/scene/",
     {"carom/", "effects/domains_suit.hpp", "fill/", "json/", "scene/", "fmt/"}},
    {"engine/src/simulation",
     {"carom/", "simulation", "impact_record.hpp", "numbers/", "state/", "contact/", "effects/",
      "solvers/", "crew/", "scene/available.hpp", "fmt/"}},
    {"engine/src/accuracy/nonnegative_least_squares", {"accuracy/", "Eigen/"}},
    {"engine/src/accuracy/", {"carom/", "accuracy/", "fmt/"}},
    {"engine/src/verify/", {"carom/", "verify/", "fill/random.hpp", "fmt/"}},
    {"engine/src/report/", {"carom/", "json/", "fmt/"}},
    {"engine/src/", {"carom/", "impact_record.hpp", "state/", "fmt/"}},
    {"app/view/",
     {"carom/", "view/", "export/", "text/", "ending_signals.hpp", "fmt/", "nlohmann/", "curses.h",
      "term.h"}},
    {"app/export/", {"carom/", "export/", "text/", "ending_signals.hpp", "fmt/"}},
    {"app/sweep/", {"sweep/", "text/", "options.hpp", "fmt/", "nlohmann/"}},
    {"app/text/", {"fmt/"}},
    {"app/help", {"help.hpp", "fmt/", "CLI/"}},
    {"app/options.cpp", {"carom/", "options.hpp", "option_table.hpp", "help.hpp", "fmt/", "CLI/"}},
};

/// What the engine's inside is called in includes, and what has its one place.
const std::vector<std::string> kNotForApp{
    "state/", "contact/", "effects/", "solvers/",  "crew/", "numbers/", "geometry/", "trajectory/",
    "fill/",  "report/",  "scene/",   "nlohmann/", "CLI/",  "curses.h", "ncurses",   "simulation"};

bool is_ours(const std::string& included) {
  static const std::regex kSystem(
      "[a-z_0-9]+|(sys|linux|netinet|asm|bits)/.*|[a-z_]+\\.h");  // <vector>, <sys/stat.h>,
                                                                  // <poll.h>
  return !std::regex_match(included, kSystem) || included.find("curses") != std::string::npos ||
         included == "term.h";
}

std::vector<std::string> includes_of(const fs::path& file) {
  static const std::regex kInclude("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
  std::vector<std::string> includes;
  std::istringstream lines(support::read_file(file));
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_search(line, found, kInclude)) includes.push_back(found[1]);
  }
  return includes;
}

std::vector<std::string> sources(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(kTop / folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".cpp" || extension == ".hpp") {
      files.push_back(fs::relative(entry.path(), kTop).string());
    }
  }
  return files;
}

bool begins_with_one_of(const std::string& text, const std::vector<std::string>& starts) {
  return std::any_of(starts.begin(), starts.end(),
                     [&](const std::string& start) { return text.starts_with(start); });
}

void expect_allowed(const std::string& file) {
  const auto layer = std::find_if(kLayers.begin(), kLayers.end(),
                                  [&](const Layer& each) { return file.starts_with(each.place); });
  for (const std::string& included : includes_of(kTop / file)) {
    if (!is_ours(included)) continue;
    const bool allowed = layer != kLayers.end() ? begins_with_one_of(included, layer->allowed)
                                                : !begins_with_one_of(included, kNotForApp);
    EXPECT_TRUE(allowed) << file << " includes " << included;
  }
}

TEST(Layers, EngineFilesIncludeOnlyWhatIsBelowThem) {
  const auto files = sources("engine");
  ASSERT_GT(files.size(), 20U);
  for (const std::string& file : files) expect_allowed(file);
}

TEST(Layers, TheAppSeesThePublicHeadersOnly) {
  const auto files = sources("app");
  ASSERT_GT(files.size(), 10U);
  for (const std::string& file : files) expect_allowed(file);
}

TEST(Layers, EveryHeaderIsGuardedByPragmaOnce) {
  for (const char* folder : {"engine", "app", "tests"}) {
    for (const std::string& file : sources(folder)) {
      if (!file.ends_with(".hpp")) continue;
      EXPECT_NE(support::read_file(kTop / file).find("#pragma once\n"), std::string::npos) << file;
    }
  }
}

}  // namespace
}  // namespace carom::layers_test
