// Holds scenes/scene.schema.json and the reader together: the same keys in the same places, and
// every limit of the schema is one of the reader's.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "carom/scene_file.hpp"
#include "scene/keys.hpp"

namespace carom {
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

  void compare_keys(const json& object, const scene::Group& group) const {
    SCOPED_TRACE(std::string(group.name));
    std::set<std::string> in_schema;
    for (const auto& [key, value] : object.at("properties").items()) in_schema.insert(key);
    std::set<std::string> in_reader;
    std::set<std::string> required;
    for (const scene::Key& key : group.keys) {
      in_reader.emplace(key.name);
      if (key.required) required.emplace(key.name);
    }
    EXPECT_EQ(in_schema, in_reader);
    EXPECT_EQ(object.value("additionalProperties", true), false);
    for (const scene::Key& key : group.keys) {
      const json property = resolved(object["properties"][std::string(key.name)]);
      if (!property.empty() && !property.contains("const")) compare_type(property, key);
      if (key.type == scene::Type::object) compare_keys(property, *key.group);
      if (key.type == scene::Type::list && key.name != "script") {
        compare_keys(resolved(property["items"]), *key.group);
      }
    }
  }

  static void compare_type(const json& property, const scene::Key& key) {
    SCOPED_TRACE(std::string(key.name));
    const std::string type = property.value("type", "");
    switch (key.type) {
      case scene::Type::text:
      case scene::Type::line_of_text:
        EXPECT_EQ(type, "string");
        break;
      case scene::Type::glyph:
        EXPECT_EQ(property.value("pattern", ""), "^[!-~]$");
        break;
      case scene::Type::flag:
        EXPECT_EQ(type, "boolean");
        break;
      case scene::Type::number:
        EXPECT_EQ(type, "number");
        break;
      case scene::Type::whole:
        EXPECT_TRUE(type == "integer" || property.contains("enum"));
        break;
      case scene::Type::pair:
      case scene::Type::corners:
        EXPECT_EQ(type, "array");
        EXPECT_EQ(property.value("minItems", 0), 2);
        EXPECT_EQ(property.value("maxItems", 0), 2);
        break;
      case scene::Type::decimal:
        EXPECT_EQ(type, "string");
        EXPECT_TRUE(property.contains("pattern"));
        break;
      case scene::Type::decimal_pair:
        EXPECT_EQ(type, "array");
        EXPECT_EQ(property.value("minItems", 0), 2);
        EXPECT_EQ(property.value("maxItems", 0), 2);
        break;
      case scene::Type::axes:
        EXPECT_EQ(property["items"]["enum"], json({"x", "y"}));
        break;
      case scene::Type::choice: {
        json words = json::array();
        for (const auto word : key.words) words.push_back(std::string(word));
        EXPECT_EQ(property["enum"], words);
        break;
      }
      case scene::Type::workers:
        EXPECT_TRUE(property.contains("anyOf"));
        break;
      case scene::Type::object:
        EXPECT_EQ(type, "object");
        break;
      case scene::Type::list:
        EXPECT_EQ(type, "array");
        break;
    }
  }

  json schema_ = load_schema();
};

TEST_F(Schema, HasTheKeysAndTypesOfTheReaderAndNoOthers) {
  compare_keys(schema_, scene::kScene);
}

TEST_F(Schema, HasTheKeysOfEveryCommandOfTheScript) {
  std::set<std::string> commands;
  for (const json& choice : schema_["definitions"]["script_line"]["oneOf"]) {
    const json command = resolved(choice);
    const std::string word = command["properties"]["command"]["const"];
    commands.insert(word);
    compare_keys(command, scene::script_line_group(word));
  }
  EXPECT_EQ(commands, (std::set<std::string>{"add", "remove", "pause", "resume", "set", "quit"}));
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
}  // namespace carom
