#include "accuracy/runner.hpp"

#include <fmt/format.h>

namespace carom::accuracy {
namespace {

Scene computed(const Scenario& scenario, const Way& way, const AccuracyCrew& crew) {
  Scene scene = scenario.start;
  scene.solver.method = way.method;
  scene.solver.digits = way.digits;
  if (way.step) scene.solver.step = *way.step;
  scene.per_ball = crew.per_ball;
  scene.workers.reset();
  if (!crew.per_ball) scene.workers = crew.workers;
  return scene;
}

}  // namespace

std::string name_of(const Way& way) {
  const char* const method = way.method == Method::event ? "event" : "overlap";
  return way.step ? fmt::format("{} at 1/{:.5g} s", method, 1 / *way.step)
                  : fmt::format("{} with {} digits", method, way.digits);
}

Runner::Runner(const Scenario& scenario, const Way& way, const AccuracyCrew& crew)
    : scenario_(scenario), simulation_(computed(scenario, way, crew)) {}

void Runner::advance_to(double time) {
  const auto& commands = scenario_.commands;
  for (; next_ < commands.size() && commands[next_].at <= time; ++next_) {
    simulation_.advance_to(commands[next_].at);
    simulation_.apply(commands[next_].command);
  }
  simulation_.advance_to(time);
}

}  // namespace carom::accuracy
