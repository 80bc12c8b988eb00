#include "accuracy/scenario.hpp"

#include <algorithm>
#include <variant>

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

  // The frame clock runs on while paused; simulated time is the clock less that.
  const Continuation past = scene.continuation.value_or(Continuation{});
  double clock = past.clock;
  double stood_still = 0;
  bool paused = past.paused;
  for (const ScriptLine& line : scene.script) {
    if (line.at < past.clock) continue;
    if (paused) stood_still += line.at - clock;
    clock = line.at;
    const double at = line.at - past.clock - stood_still;
    if (at > scenario.end) return scenario;
    if (std::holds_alternative<command::Pause>(line.command)) {
      paused = true;
    } else if (std::holds_alternative<command::Resume>(line.command)) {
      paused = false;
    } else if (std::holds_alternative<command::Quit>(line.command)) {
      scenario.end = at;
      return scenario;
    } else if (!std::holds_alternative<command::SetStep>(line.command)) {
      scenario.commands.push_back({at, line.command});
    }
  }
  if (paused) scenario.end = std::min(scenario.end, clock - past.clock - stood_still);
  return scenario;
}

}  // namespace carom::accuracy
