#include <fmt/format.h>

#include <algorithm>

#include "carom/footprint.hpp"
#include "carom/scene_file.hpp"
#include "commands.hpp"
#include "load_scene.hpp"
#include "standard_streams.hpp"
#include "text/counted.hpp"
#include "warnings.hpp"

namespace carom {

namespace {

constexpr std::string_view kSchemaEnding = ".schema.json";

std::string row(std::string_view name, std::string_view value) {
  return fmt::format("  {:<15}{}\n", name, value);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += text.empty() ? word : ", " + word;
  return text.empty() ? "nothing" : text;
}

/// Both lists together name every effect there is.
struct EffectLists {
  std::vector<std::string> simulated;
  std::vector<std::string> not_simulated;
};

std::string values(const Walls& walls) {
  return fmt::format("restitution {:g}{}", walls.restitution, walls.on ? "" : ", switched off");
}
std::string values(const Collisions& collisions) {
  return fmt::format("restitution {:g}{}", collisions.restitution,
                     collisions.on ? "" : ", switched off");
}
std::string values(const Gravity& gravity) {
  return fmt::format("{:g}, {:g}", gravity.acceleration.x(), gravity.acceleration.y());
}
std::string values(const Drag& drag) {
  return fmt::format("rate {:g}", drag.rate);
}
std::string values(const Friction& friction) {
  return fmt::format("balls {:g}, walls {:g}", friction.balls, friction.walls);
}
std::string values(const Attraction& attraction) {
  return fmt::format("strength {:g}, softening {:g}", attraction.strength, attraction.softening);
}

EffectLists list_effects(const Effects& effects) {
  EffectLists lists;
  for_each_effect([&](const auto& entry) {
    if (const auto& effect = effects.*entry.slot) {
      lists.simulated.push_back(fmt::format("{} ({})", entry.name, values(*effect)));
    } else {
      lists.not_simulated.emplace_back(entry.name);
    }
  });
  return lists;
}

std::string sides(const Scene& scene) {
  const char* solid = scene.effects.walls ? "walls" : "open sides";
  const auto [x, y] = scene.box.periodic;
  if (x && y) return "periodic in x and y";
  if (x) return fmt::format("periodic in x, {} in y", solid);
  if (y) return fmt::format("periodic in y, {} in x", solid);
  return solid;
}

std::string threads(const Scene& scene, const Footprint& footprint) {
  return fmt::format("{}: the control thread and {}{}", footprint.workers + 1,
                     counted(footprint.workers, "worker", "workers"),
                     scene.per_ball ? ", one per ball" : "");
}

std::string method_text(const Scene& scene, Method method) {
  if (method == Method::overlap) return fmt::format("overlap, step {:.6g} s", scene.solver.step);
  return fmt::format("event, {} digits", scene.solver.digits);
}

std::string describe(const std::string& file, const Scene& scene) {
  const std::vector<Ball> balls = populate(scene);
  const Footprint footprint = carom::footprint(scene, balls);
  const EffectLists effects = list_effects(scene.effects);
  const MethodChoice choice = choose_method(scene);
  const auto fixed = static_cast<std::size_t>(
      std::count_if(balls.begin(), balls.end(), [](const Ball& ball) { return ball.fixed; }));

  std::string text = fmt::format("{}: valid\n", file);
  if (!scene.name.empty()) text += row("name", scene.name);
  text += row("simulated", joined(effects.simulated));
  text += row("not simulated", joined(effects.not_simulated));
  text +=
      row("box", fmt::format("{:g} x {:g}, {}", scene.box.width, scene.box.height, sides(scene)));
  text += row("balls", fixed == 0 ? fmt::format("{}", balls.size())
                                  : fmt::format("{}, {} of them fixed", balls.size(), fixed));
  text += row("pairs", scene.effects.collisions ? fmt::format("{}", footprint.pairs)
                                                : "none: balls pass through each other");
  text += row("method", fmt::format("{}: {}", method_text(scene, choice.method), choice.why));
  text += row("duration",
              fmt::format("{:g} s at {:g} frames per second", scene.duration, scene.frame_rate));
  text += row("script",
              scene.script.empty() ? "none" : counted(scene.script.size(), "command", "commands"));
  text += row("threads", threads(scene, footprint));
  text += row("barriers", joined(footprint.barriers));
  text += row("memory", counted(footprint.bytes(), "byte", "bytes"));
  for (const auto& [name, bytes] : footprint.columns) {
    text += fmt::format("    {:<13}{}\n", name, bytes);
  }
  for (const auto& [name, bytes] : footprint.lists) {
    text += fmt::format("    {:<13}{} (estimated)\n", name, bytes);
  }
  return text;
}

void print_problems(const SceneError& error) {
  constexpr std::size_t kMostTold = 50;
  const auto& problems = error.problems();
  const std::size_t told = std::min(problems.size(), kMostTold);
  for (std::size_t i = 0; i < told; ++i) print_error_line(error.line(problems[i]));
  if (problems.size() > told) {
    print_error_line(
        fmt::format("{}: and {} more problems", error.source(), problems.size() - told));
  }
}

}  // namespace

int check(const Options& options) {
  bool good = true;
  for (const std::string& file : options.scenes) {
    if (file.ends_with(kSchemaEnding)) {
      print(fmt::format("{}: the schema of scenes, not a scene\n", file));
      continue;
    }
    try {
      const Scene scene = load_scene(file, options);
      print(describe(file, scene));
      print_warnings(scene, scene.duration);
    } catch (const SceneError& error) {
      good = false;
      print_problems(error);
    }
  }
  return good ? 0 : 2;
}

}  // namespace carom
