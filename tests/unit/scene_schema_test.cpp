// Holds scenes/scene.schema.json and the reader together: it is made from the table of keys, and
// every limit of it is one of the reader's.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "carom/scene_file.hpp"

namespace carom::scene_schema_test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const fs::path kScenes = CAROM_SOURCE_DIR "/scenes";

json load_schema() {
  std::ifstream in(kScenes / "scene.schema.json");
  return json::parse(in);
}

class Schema : public testing::Test {
 protected:
  /// A part of the schema with the parts that it refers to put into it.
  json resolved(json part) const {
    while (part.contains("$ref")) {
      const std::string ref = part["$ref"].get<std::string>().substr(1);
      json target = schema_.at(json::json_pointer(ref));
      part.erase("$ref");
      target.update(part);
      part = target;
    }
    return part;
  }

  json definition(const std::string& name) const { return resolved(schema_["definitions"][name]); }

  json schema_ = load_schema();
};

/// With CAROM_SCHEMA=FILE the schema is written there.
TEST_F(Schema, IsTheOneThatTheTableOfKeysGives) {
  if (const char* file = std::getenv("CAROM_SCHEMA")) std::ofstream(file) << scene_schema();
  std::ifstream in(kScenes / "scene.schema.json");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(text, scene_schema());
}

/// Places of the problems of a scene.
std::vector<std::string> places_of(const json& scene) {
  try {
    parse_scene(scene.dump(), "probe");
  } catch (const SceneError& error) {
    std::vector<std::string> places;
    for (const Problem& problem : error.problems()) places.push_back(problem.place);
    return places;
  }
  return {};
}

TEST_F(Schema, HasTheLimitsOfTheReader) {
  const json bare = json::parse(R"({
    "box": {"width": 20, "height": 10},
    "effects": {"walls": {}, "collisions": {}, "gravity": [0, -1], "drag": {"rate": 0},
                "friction": {}, "attraction": {"strength": 0}},
    "balls": [{"position": [3, 5]}], "fill": [{"count": 1}], "solver": {}, "continuation": {},
    "script": [{"at": 1, "command": "add", "ball": {"position": [5, 5]}},
               {"at": 1, "command": "remove"},
               {"at": 1, "command": "set", "effects": {"walls": {}, "collisions": {}, "drag": {},
                "friction": {}, "attraction": {}}, "solver": {}}]
  })");
  std::size_t probes = 0;
  const auto probe = [&](const std::string& place, const json& value, bool good) {
    json scene = bare;
    scene[json::json_pointer(place)] = value;
    const auto places = places_of(scene);
    const bool refused = std::find(places.begin(), places.end(), place) != places.end();
    EXPECT_EQ(refused, !good) << place << " = " << value.dump();
    ++probes;
  };
  const auto probe_object = [&](const auto& self, const json& object,
                                const std::string& place) -> void {
    for (const auto& [key, part] : object.at("properties").items()) {
      const json property = resolved(part);
      const std::string at = fmt::format("{}/{}", place, key);
      if (property.contains("exclusiveMinimum")) {
        probe(at, property["exclusiveMinimum"], false);
        probe(at, -1, false);
      }
      if (property.contains("minimum")) {
        probe(at, property["minimum"], true);
        probe(at, property["minimum"].get<double>() - 1, false);
      }
      if (property.value("type", "") == "number" && property.contains("maximum")) {
        probe(at, property["maximum"], true);
        probe(at, property["maximum"].get<double>() + 0.5, false);
      }
      if (property.value("type", "") == "integer") probe(at, 1.5, false);
      if (property.contains("enum")) probe(at, "none of these", false);
      if (property.contains("default") && key != "digits" && key != "fixed") {
        probe(at, property["default"], true);
      }
      if (property.contains("properties")) self(self, property, at);
    }
  };
  probe_object(probe_object, schema_, "");
  probe_object(probe_object, definition("ball"), "/balls/0");
  probe_object(probe_object, definition("fill"), "/fill/0");
  probe_object(probe_object, definition("ball"), "/script/0/ball");
  probe_object(probe_object, definition("set"), "/script/2");
  EXPECT_GT(probes, 60U);
}

TEST_F(Schema, IsNamedByEveryScene) {
  std::size_t scenes = 0;
  for (const auto& entry : fs::directory_iterator(kScenes)) {
    if (entry.path().extension() != ".json" || entry.path().filename() == "scene.schema.json") {
      continue;
    }
    SCOPED_TRACE(entry.path().string());
    ++scenes;
    std::ifstream in(entry.path());
    const json text = json::parse(in);
    EXPECT_EQ(text.value("$schema", ""), "scene.schema.json");
    const Scene scene = read_scene(entry.path());
    EXPECT_EQ(scene.name, entry.path().stem().string());
    EXPECT_FALSE(scene.about.empty());
    EXPECT_FALSE(populate(scene).empty());
  }
  EXPECT_GE(scenes, 8U);
}

}  // namespace
}  // namespace carom::scene_schema_test
