// What a scene does not name costs nothing: no memory, no instruction, no phase, no line of a
// report.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "carom/effects.hpp"
#include "support/process.hpp"

namespace carom::effects_cost_test {
namespace {

using nlohmann::json;
using Names = std::set<std::string>;

const std::map<std::string, std::string> kWritten{
    {"walls", R"("walls": {})"},
    {"collisions", R"("collisions": {})"},
    {"gravity", R"("gravity": [0, -1])"},
    {"drag", R"("drag": {"rate": 0.1})"},
    {"friction", R"("friction": {"balls": 0.2, "walls": 0.3})"},
    {"attraction", R"("attraction": {"strength": 0.1, "softening": 0.5})"},
};

Names every_effect() {
  Names names;
  for_each_effect([&](const auto& entry) { names.emplace(entry.name); });
  return names;
}

constexpr std::size_t kBalls = 4;

class Cost : public testing::Test {
 protected:
  support::Outcome carom(std::vector<std::string> words, const Names& effects,
                         const std::string& method = "overlap") {
    std::string list;
    for (const std::string& name : effects) {
      list += (list.empty() ? "" : ", ") + kWritten.at(name);
    }
    support::write_file(folder_ / "scene.json",
                        R"({"box": {"width": 8, "height": 8}, "solver": {"method": ")" + method +
                            R"("}, "effects": {)" + list +
                            R"(}, "balls": [{"position": [1, 1], "velocity": [1, 2]},
                            {"position": [3, 5]}, {"position": [6, 2]}, {"position": [6, 6]}]})");
    words.insert(words.begin(), CAROM_PROGRAM);
    return support::run(words, {folder_.path(), ""});
  }

  std::map<std::string, std::size_t> memory(const Names& effects) {
    const auto outcome = carom({"check", "scene.json"}, effects);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::map<std::string, std::size_t> bytes;
    static const std::regex kRow("^    ([a-z_]+) +([0-9]+)");
    std::istringstream lines(outcome.out);
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
      if (std::regex_search(line, found, kRow)) bytes[found[1]] = std::stoul(found[2]);
    }
    return bytes;
  }

  json report(const Names& effects, const std::string& method = "overlap",
              const std::string& time = "0.1") {
    const auto outcome =
        carom({"run", "scene.json", "--time", time, "--quiet", "--report", "-"}, effects, method);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return json::parse(outcome.out);
  }

  support::TemporaryFolder folder_;
};

TEST_F(Cost, OfMemoryIsThatOfTheEffectsThatAreNamed) {
  const auto bare = memory({});
  EXPECT_GE(bare.size(), 5U);
  const std::map<std::string, std::map<std::string, std::size_t>> more{
      {"walls", {}},
      {"collisions", {{"pairs", kBalls * (kBalls - 1) / 2 * 16}}},
      {"gravity", {}},
      {"drag", {}},
      {"friction", {{"spin", kBalls * 8}}},
      {"attraction", {{"pull", kBalls * 16}}},
  };
  EXPECT_EQ(more.size(), kEffectCount);
  for (const auto& [name, rows] : more) {
    auto expected = bare;
    expected.insert(rows.begin(), rows.end());
    EXPECT_EQ(memory({name}), expected) << name;
  }
}

TEST_F(Cost, OfThreadsIsThatOfTheEffectsThatAreNamed) {
  const auto phases = [&](const Names& effects) {
    Names names;
    const json reported = report(effects);
    for (const auto& [name, seconds] : reported["phases"].items()) names.insert(name);
    return names;
  };
  const Names bare{"flight"};
  EXPECT_EQ(phases({}), bare);
  EXPECT_EQ(phases({"gravity", "drag", "friction"}), bare);
  EXPECT_EQ(phases({"walls"}), Names{"wall_computation"});
  EXPECT_EQ(phases({"collisions"}), (Names{"flight", "pair_computation"}));
  EXPECT_EQ(phases({"attraction"}), (Names{"flight", "attraction"}));
  const auto checked = carom({"check", "scene.json"}, {"gravity"}).out;
  EXPECT_NE(checked.find("do_frame, flight, frame_done"), std::string::npos) << checked;
}

TEST_F(Cost, IsReportedForTheEffectsThatAreNamed) {
  for (const std::string method : {"overlap", "event"}) {
    const auto reported = [&](const Names& effects) {
      Names names;
      const json told = report(effects, method);
      EXPECT_EQ(told["method"].get<std::string>(), method);
      for (const auto& [name, cost] : told["effects"].items()) {
        EXPECT_GE(cost["seconds"].get<double>(), 0);
        names.insert(name);
      }
      return names;
    };
    EXPECT_EQ(reported({}), Names{}) << method;
    for (const std::string& name : every_effect()) {
      EXPECT_EQ(reported({name}), Names{name}) << method;
    }
    EXPECT_EQ(reported(every_effect()), every_effect()) << method;
  }
}

// In closed form only events cost anything, and the sample begins with the first.
TEST_F(Cost, OfExactEventsIsSharedAmongTheEffectsThatDoThem) {
  const Names some{"walls", "collisions", "gravity", "drag", "friction"};
  // So few events have but a few samples, and one that is interrupted may count for nothing.
  std::map<std::string, double> most;
  for (int run = 0; run < 5; ++run) {
    const json told = report(some, "event", "20");
    EXPECT_GT(told["events"]["ball_ball"], 0);
    for (const std::string& name : some) {
      most[name] = std::max(most[name], told["effects"][name]["seconds"].get<double>());
    }
  }
  for (const std::string& name : some) EXPECT_GT(most[name], 0) << name;
  const json of_walls = report({"walls"}, "event", "20");
  for (const auto& [name, cost] : of_walls["effects"].items()) {
    EXPECT_GT(cost["seconds"], 0) << name;
  }
}

TEST_F(Cost, IsTold) {
  const auto lists = [&](const Names& effects) {
    const std::string out = carom({"check", "scene.json"}, effects).out;
    Names both;
    for (const std::string row : {"  simulated ", "  not simulated "}) {
      std::istringstream lines(out);
      for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(row)) continue;
        for (const std::string& name : every_effect()) {
          if (line.find(name) != std::string::npos) both.insert(row + name);
        }
      }
    }
    return both;
  };
  for (const std::string& named : every_effect()) {
    Names expected;
    for (const std::string& name : every_effect()) {
      expected.insert((name == named ? "  simulated " : "  not simulated ") + name);
    }
    if (named == "friction") {
      // Its coefficients are called by what they are between.
      expected.insert("  simulated walls");
    }
    EXPECT_EQ(lists({named}), expected);
  }
}

// The valgrind of Debian 12 does not run programs built with sanitizers.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

/// The functions that others can call in the files of each effect.
std::map<std::string, Names> functions_of_effects() {
  const std::map<std::string, std::string> effect_of_file{{"walls.cpp.o", "walls"},
                                                          {"collisions.cpp.o", "collisions"},
                                                          {"contact_group.cpp.o", "collisions"},
                                                          {"wall_contacts.cpp.o", "walls"},
                                                          {"ball_contact.cpp.o", "collisions"},
                                                          {"island_friction.cpp.o", "friction"},
                                                          {"gravity.cpp.o", "gravity"},
                                                          {"drag.cpp.o", "drag"},
                                                          {"friction.cpp.o", "friction"},
                                                          {"attraction.cpp.o", "attraction"}};
  const auto outcome = support::run({"/usr/bin/nm", "--defined-only", CAROM_ENGINE});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::map<std::string, Names> functions;
  std::string effect;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with(".o:")) {
      const auto found = effect_of_file.find(line.substr(0, line.size() - 1));
      effect = found == effect_of_file.end() ? "" : found->second;
    } else if (!effect.empty() && (line.find(" T _ZN5carom7effects") != std::string::npos ||
                                   line.find(" T _ZN5carom7contact") != std::string::npos)) {
      functions[effect].insert(line.substr(line.rfind(' ') + 1));
    }
  }
  return functions;
}

TEST_F(Cost, OfInstructionsIsThatOfTheEffectsThatAreNamed) {
  const auto functions = functions_of_effects();
  ASSERT_EQ(functions.size(), kEffectCount);
  const std::vector<Names> scenes{{},
                                  {"walls"},
                                  {"collisions"},
                                  {"gravity"},
                                  {"drag"},
                                  {"walls", "collisions", "friction"},
                                  {"attraction"},
                                  {"walls", "collisions", "gravity", "drag", "attraction"},
                                  every_effect()};
  for (const Names& named : scenes) {
    const std::string out = folder_ / "callgrind";
    std::vector<std::string> words{
        "/usr/bin/valgrind",           "--tool=callgrind", "--demangle=no", "--compress-strings=no",
        "--callgrind-out-file=" + out, CAROM_PROBE};
    words.insert(words.end(), named.begin(), named.end());
    const auto outcome = support::run(words);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    Names called;
    std::istringstream lines(support::read_file(out));
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("fn=")) called.insert(line.substr(3, line.find('\'') - 3));
    }
    for (const auto& [effect, names] : functions) {
      std::string found;
      for (const std::string& name : names) {
        if (called.contains(name)) found += ' ' + name;
      }
      EXPECT_EQ(!found.empty(), named.contains(effect)) << effect << ":" << found;
    }
  }
}

#endif

}  // namespace
}  // namespace carom::effects_cost_test
