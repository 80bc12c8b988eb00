// Every member of a report, every column of a table and every key of a scene is in its manual page.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "support/process.hpp"

namespace carom::pages_test {
namespace {

using Json = nlohmann::json;

const std::string kScenes = CAROM_SOURCE_DIR "/scenes/";

/// The words of a page, of letters and underscores.
std::set<std::string> words_of(const std::string& page) {
  const std::string text = support::read_file(CAROM_SOURCE_DIR "/man/" + page);
  const std::regex word("[$A-Za-z_]+");
  std::set<std::string> words;
  for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it) {
    words.insert(it->str());
  }
  return words;
}

/// The members of an object and of what is in it; below a member of `open` they are data.
void collect(const Json& json, const std::set<std::string>& open, std::set<std::string>& names) {
  if (json.is_array()) {
    for (const Json& each : json) collect(each, open, names);
  }
  if (!json.is_object()) return;
  for (const auto& [name, value] : json.items()) {
    names.insert(name);
    if (open.contains(name)) {
      for (const Json& each : value) collect(each, open, names);
    } else {
      collect(value, open, names);
    }
  }
}

void expect_documented(const std::set<std::string>& names, const std::string& page) {
  const std::set<std::string> words = words_of(page);
  for (const std::string& name : names) {
    // A spread is told once for all quantities.
    const std::size_t spread = name.rfind("_spread");
    const std::string base = spread == std::string::npos ? name : name.substr(0, spread);
    EXPECT_TRUE(words.contains(base)) << name << " is not in " << page;
  }
}

std::set<std::string> members_written(std::vector<std::string> arguments,
                                      const std::string& option) {
  const support::TemporaryFolder folder;
  const std::string file = (folder / "file.json").string();
  arguments.insert(arguments.begin(), CAROM_PROGRAM);
  arguments.insert(arguments.end(), {option, file});
  const support::Outcome outcome = support::run(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::set<std::string> names;
  collect(Json::parse(support::read_file(file)), {"phases", "effects", "observables"}, names);
  EXPECT_GE(names.size(), 5U);
  return names;
}

TEST(Pages, HaveEveryMemberOfAReport) {
  for (const char* scene : {"everything.json", "friction.json", "pile.json"}) {
    expect_documented(
        members_written({"run", kScenes + scene, "--time", "0.1", "--quiet"}, "--report"),
        "carom-output.5");
  }
}

TEST(Pages, HaveEveryMemberOfAStudy) {
  const std::vector<std::string> brief{"--time",  "0.1",     "--share", "0.001",
                                       "--quiet", "--seeds", "2"};
  for (const std::vector<std::string>& start :
       {std::vector<std::string>{"accuracy", kScenes + "dense.json", "--observable", "Z"},
        {"accuracy", kScenes + "pile.json"}}) {
    std::vector<std::string> arguments = start;
    arguments.insert(arguments.end(), brief.begin(), brief.end());
    expect_documented(members_written(arguments, "--json"), "carom-output.5");
  }
}

TEST(Pages, HaveEveryMemberOfTheHardCases) {
  expect_documented(members_written({"verify", "--case", "corner"}, "--json"), "carom-output.5");
}

TEST(Pages, HaveEveryColumnOfATable) {
  for (const char* option : {"--events", "--series"}) {
    const support::TemporaryFolder folder;
    const std::string file = (folder / "table.csv").string();
    ASSERT_EQ(support::run({CAROM_PROGRAM, "run", kScenes + "gas.json", "--time", "0.1", "--quiet",
                            option, file})
                  .status,
              0);
    std::istringstream columns(
        support::read_file(file).substr(0, support::read_file(file).find('\n')));
    std::set<std::string> names;
    for (std::string name; std::getline(columns, name, ',');) names.insert(name);
    EXPECT_GE(names.size(), 10U);
    expect_documented(names, "carom-output.5");
  }
}

TEST(Pages, HaveEveryKeyOfAScene) {
  std::set<std::string> names;
  const std::function<void(const Json&)> add = [&](const Json& schema) {
    if (schema.is_array()) {
      for (const Json& each : schema) add(each);
    }
    if (!schema.is_object()) return;
    for (const auto& [name, value] : schema.items()) {
      if (name == "properties") {
        for (const auto& [key, unused] : value.items()) names.insert(key);
      }
      add(value);
    }
  };
  add(Json::parse(support::read_file(kScenes + "scene.schema.json")));
  EXPECT_GE(names.size(), 30U);
  expect_documented(names, "carom-scene.5");
}

TEST(Pages, UseTheWordsOfTheField) {
  std::string manual;
  for (const std::string& name : support::names_in(CAROM_SOURCE_DIR "/man")) {
    const std::string file = CAROM_SOURCE_DIR "/man/" + name;
    if (std::regex_match(name, std::regex(".*\\.[157]"))) manual += support::read_file(file);
  }
  manual = std::regex_replace(manual, std::regex("\\s+"), " ");
  for (const char* word : {"neighbour list", "cell list", "event queue", "event-driven",
                           "work-precision diagram", "Lyapunov", "packing fraction", "time step",
                           "speedup", "Pareto front", "predictability horizon"}) {
    EXPECT_NE(manual.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace carom::pages_test
