#pragma once

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/process.hpp"

namespace carom::test {

using Json = nlohmann::json;
using Row = std::map<std::string, std::string>;

/// A gas that loses energy, with friction; one ball is added and the first is removed.
inline std::string lossy(const std::string& more = "") {
  return R"({"name": "box", "box": {"width": 10, "height": 8},
    "effects": {"collisions": {"restitution": 0.9}, "walls": {"restitution": 0.8},
                "friction": {"balls": 0.2, "walls": 0.3})" +
         more + R"(},
    "fill": [{"count": 30, "radius": 0.3, "temperature": 2}], "seed": 3, "duration": 3,
    "script": [{"at": 1, "command": "add", "ball": {"position": [0.011, 0.011], "radius": 0.01}},
               {"at": 2, "command": "remove", "ball": 0}]})";
}

inline std::string periodic_gas(std::size_t count, double radius, double duration) {
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
    return support::read_file(folder_ / name);
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

  support::TemporaryFolder folder_;
};

inline double number(const Row& row, const char* name) {
  return std::stod(row.at(name));
}

inline const char* const kOverlap = R"(}, "solver": {"method": "overlap")";

/// The three methods of computing: event, overlap, and event with attraction.
inline std::vector<std::string> lossy_scenes() {
  return {lossy(), lossy(kOverlap), lossy(R"(, "attraction": {"strength": 0.01, "softening": 1})")};
}

}  // namespace carom::test
