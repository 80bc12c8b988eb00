#include "load_scene.hpp"

#include <fmt/format.h>

#include <array>
#include <iostream>
#include <iterator>
#include <utility>

#include "carom/scene_file.hpp"
#include "values.hpp"

namespace carom {
namespace {

constexpr const char* kStandardInput = "standard input";

/// The option that replaces a place of the scene.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kOptionOf{
    {{"/solver/method", "--method"},
     {"/solver/step", "--step"},
     {"/solver/digits", "--digits"},
     {"/workers", "--workers"},
     {"/seed", "--seed"}}};

Scene replaced(Scene scene, const std::string& source, const Options& options) {
  if (options.method) scene.solver.method = options.method;
  if (options.step) scene.solver.step = *options.step;
  if (options.digits) scene.solver.digits = *options.digits;
  if (options.seed) scene.seed = *options.seed;
  if (options.workers) {
    scene.per_ball = *options.workers == "per-ball";
    scene.workers.reset();
    if (!scene.per_ball) scene.workers = std::stoull(*options.workers);
  }
  const auto problems = find_problems(scene);
  if (problems.empty()) return scene;
  for (const auto& [place, option] : kOptionOf) {
    if (problems.front().place == place) {
      throw UsageError(fmt::format("{}: {}", option, problems.front().message));
    }
  }
  throw SceneError(source, problems);
}

}  // namespace

Scene load_scene(const std::string& file, const Options& options) {
  if (file != "-") return replaced(read_scene(file), file, options);
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  return replaced(parse_scene(text, kStandardInput), kStandardInput, options);
}

Scene load_builtin_scene(const Options& options) {
  return replaced(builtin_scene(), "the built-in scene", options);
}

}  // namespace carom
