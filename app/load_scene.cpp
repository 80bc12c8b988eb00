#include "load_scene.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <stdexcept>
#include <utility>

#include "carom/names.hpp"
#include "carom/scene_change.hpp"
#include "carom/scene_file.hpp"
#include "scene_files.hpp"

namespace carom {
namespace {

/// The option that replaces a place of the scene.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kOptionOf{
    {{"/solver/method", "--method"},
     {"/solver/step", "--step"},
     {"/solver/digits", "--digits"},
     {"/workers", "--workers"},
     {"/seed", "--seed"}}};

std::vector<SceneChange> changes_of(const Options& options) {
  std::vector<SceneChange> changes;
  for (const std::string& text : options.set) {
    try {
      changes.push_back(parse_change(text));
    } catch (const std::invalid_argument& error) {
      throw UsageError(fmt::format("--set {}: {}", text, error.what()));
    }
  }
  return changes;
}

/// One place is the other or is within it.
bool meet(std::string_view one, std::string_view other) {
  if (one.size() > other.size()) std::swap(one, other);
  return other.starts_with(one) && (other.size() == one.size() || other[one.size()] == '/');
}

/// Names the option in place of the scene, where it is the option that the scene cannot take.
[[noreturn]] void refuse(const SceneError& error, const Options& options) {
  const Problem& problem = error.problems().front();
  for (const std::string& text : options.set) {
    const std::string pointer = text.substr(0, text.find('='));
    if (problem.place.empty() || !meet(pointer, problem.place)) continue;
    const std::string place = problem.place == pointer ? "" : problem.place + ": ";
    throw UsageError(fmt::format("--set {}: {}{}", text, place, problem.message));
  }
  throw error;
}

/// Of the scene with the options, and of running it for as long as they say; how long a run may be
/// at all is judged by its schedule.  The balls are as they were read.
std::vector<Problem> problems_of(Scene& scene, const Options& options) {
  if (!options.method && !options.step && !options.digits && !options.seed && !options.workers &&
      !options.time) {
    return {};
  }
  std::vector<Problem> problems = find_problems(scene, Known::balls);
  if (!problems.empty() || !options.time) return problems;
  const double duration = std::exchange(scene.duration, *options.time);
  problems = find_problems(scene, Known::balls);
  scene.duration = duration;
  std::erase_if(problems, [](const Problem& problem) { return problem.place == "/duration"; });
  return problems;
}

Scene replaced(Scene scene, const std::string& source, const Options& options) {
  if (options.method) scene.solver.method = options.method;
  if (options.step) scene.solver.step = *options.step;
  if (options.digits) scene.solver.digits = *options.digits;
  if (options.seed) scene.seed = *options.seed;
  if (options.workers) {
    scene.per_ball = *options.workers == kPerBall;
    scene.workers.reset();
    if (!scene.per_ball) scene.workers = std::stoull(*options.workers);
  }
  const auto problems = problems_of(scene, options);
  if (problems.empty()) return scene;
  for (const auto& [place, option] : kOptionOf) {
    if (problems.front().place == place) {
      throw UsageError(fmt::format("{}: {}", option, problems.front().message));
    }
  }
  refuse(SceneError(source, problems), options);
}

Scene load(const Options& options,
           const std::function<Scene(std::span<const SceneChange> changes)>& read) {
  const std::vector<SceneChange> changes = changes_of(options);
  Scene scene = [&] {
    try {
      return read(changes);
    } catch (const SceneError& error) {
      refuse(error, options);
    }
  }();
  const std::string source = scene.source;
  return replaced(std::move(scene), source, options);
}

/// A word that is no file may be the misspelt name of a scene.
void refuse_unknown_name(const std::string& name, const std::filesystem::path& file) {
  std::error_code ignored;
  if (name == "-" || name.find('/') != std::string::npos || name.find('.') != std::string::npos ||
      std::filesystem::exists(file, ignored)) {
    return;
  }
  const std::vector<std::string> names = scene_names();
  const std::vector<std::string_view> words(names.begin(), names.end());
  const std::string_view nearest = nearest_word(name, words);
  throw SceneError(
      name,
      {{"", fmt::format("is neither a file nor an installed scene{}; carom scenes lists them",
                        nearest.empty() ? "" : fmt::format(", the nearest one is {}", nearest))}});
}

}  // namespace

Scene load_scene(const std::string& name, const Options& options) {
  const std::filesystem::path file = find_scene(name);
  refuse_unknown_name(name, file);
  return load(options,
              [&](std::span<const SceneChange> changes) { return read_scene(file, changes); });
}

Scene load_builtin_scene(const Options& options) {
  return load(options, [](std::span<const SceneChange> changes) { return builtin_scene(changes); });
}

}  // namespace carom
