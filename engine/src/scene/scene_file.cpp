#include "carom/scene_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace carom {

SceneError::SceneError(std::string source, std::vector<Problem> problems)
    : std::runtime_error(
          fmt::format("{}: {}: {}", source, problems.front().place, problems.front().message)),
      source_(std::move(source)),
      problems_(std::move(problems)) {}

std::string SceneError::line(const Problem& problem) const {
  return fmt::format("{}: {}: {}", source_, problem.place, problem.message);
}

Scene read_scene(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return parse_scene(text.str(), file.string());
}

Scene parse_scene(std::string_view text, const std::string& source) {
  Scene scene;
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw SceneError(source, {{"", error.what()}});
  }
  const auto vec = [](const nlohmann::json& j) {
    return Vec2{j[0].get<double>(), j[1].get<double>()};
  };
  scene.name = json.value("name", "");
  scene.box.width = json["box"]["width"];
  scene.box.height = json["box"]["height"];
  const auto& effects = json["effects"];
  if (effects.contains("walls"))
    scene.effects.walls = Walls{effects["walls"].value("restitution", 1.0)};
  if (effects.contains("collisions"))
    scene.effects.collisions = Collisions{effects["collisions"].value("restitution", 1.0)};
  if (effects.contains("gravity")) scene.effects.gravity = Gravity{vec(effects["gravity"])};
  for (const auto& j : json["balls"]) {
    Ball ball;
    ball.position = vec(j["position"]);
    if (j.contains("velocity")) ball.velocity = vec(j["velocity"]);
    ball.radius = j.value("radius", 0.5);
    ball.mass = j.value("mass", 1.0);
    ball.fixed = j.value("fixed", false);
    scene.balls.push_back(ball);
  }
  return scene;
}

std::vector<Problem> find_problems(const Scene&) {
  return {};
}
std::string write_scene(const Scene&) {
  return "{}";
}

Scene builtin_scene() {
  Scene scene;
  scene.name = "break";
  scene.effects.walls = Walls{};
  scene.effects.collisions = Collisions{};
  scene.balls.push_back(Ball{{4, 5}, {9, 0.3}});
  return scene;
}

}  // namespace carom
