#include "accuracy/scenario.hpp"

#include <algorithm>
#include <variant>

#include "carom/frame_clock.hpp"
#include "carom/simulation.hpp"

namespace carom::accuracy {
namespace {

/// The balls that a run begins with; a saved scene may hold more about them than their positions.
std::vector<Ball> first_balls(const Scene& scene) {
  if (!scene.continuation) return populate(scene);
  Scene alone = scene;
  alone.workers = 1;
  alone.per_ball = false;
  return Simulation(alone).state();
}

}  // namespace

Scenario scenario_of(const Scene& scene, std::optional<double> time) {
  Scenario scenario;
  scenario.end = time.value_or(scene.duration);
  scenario.start = scene;
  scenario.start.balls = first_balls(scene);
  scenario.start.fills.clear();
  scenario.start.script.clear();
  scenario.start.continuation.reset();

  FrameClock clock;
  double start = 0;
  if (scene.continuation) {
    clock = FrameClock(*scene.continuation);
    start = scene.continuation->time;
  }
  double simulated = start;
  for (const ScriptLine& line : scene.script) {
    if (line.at < clock.now()) continue;
    clock.move_to(line.at);
    if (!clock.paused()) simulated = clock.time();
    const double at = simulated - start;
    if (at > scenario.end) return scenario;
    if (std::holds_alternative<command::Pause>(line.command)) {
      clock.pause();
    } else if (std::holds_alternative<command::Resume>(line.command)) {
      clock.resume(simulated);
    } else if (std::holds_alternative<command::Quit>(line.command)) {
      scenario.end = at;
      return scenario;
    } else if (!std::holds_alternative<command::SetStep>(line.command)) {
      scenario.commands.push_back({at, line.command});
    }
  }
  if (clock.paused()) scenario.end = std::min(scenario.end, simulated - start);
  return scenario;
}

std::vector<Scenario> starts_of(const Scene& scene, std::size_t seeds, std::optional<double> time) {
  std::vector<Scenario> starts;
  const std::size_t count = scene.fills.empty() ? 1 : std::max<std::size_t>(1, seeds);
  Scene drawn = scene;
  for (std::size_t i = 0; i < count; ++i) {
    drawn.seed = scene.seed + i;
    starts.push_back(scenario_of(drawn, time));
  }
  return starts;
}

}  // namespace carom::accuracy
