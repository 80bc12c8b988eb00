#include "warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "standard_streams.hpp"

namespace carom {

namespace {

void warn(const Scene& scene, const std::string& words) {
  print_error(fmt::format("carom: warning: {}: {}\n",
                          scene.source.empty() ? "the scene" : scene.source, words));
}

// Of the masses of balls that can lie on each other.
double mass_ratio(const Scene& scene) {
  const Effects& effects = scene.effects;
  if (!effects.gravity || !effects.collisions || !effects.collisions->on) return 1;
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  const auto take = [&](double mass) {
    least = std::min(least, mass);
    most = std::max(most, mass);
  };
  for (const Ball& ball : scene.balls) {
    if (!ball.fixed) take(ball.mass);
  }
  for (const Fill& fill : scene.fills) take(fill.mass);
  return most > 0 ? most / least : 1;
}

}  // namespace

void print_warnings(const Scene& scene, double seconds) {
  if (choose_method(scene).method != Method::overlap) {
    constexpr double kMostRatio = 1e7;
    if (const double ratio = mass_ratio(scene); ratio > kMostRatio && loses_energy(scene)) {
      warn(scene, fmt::format("masses of 1 : {:.2g} under gravity: event lets heavy balls sink "
                              "into light ones beyond 1 : 1e7; use masses that are nearer",
                              ratio));
    }
    return;
  }
  const double step = scene.solver.step;
  if (seconds > 0 && step > seconds) {
    warn(scene, fmt::format("/solver/step: {:.4g} s is longer than the run of {:.4g} s: overlap "
                            "takes whole steps, so nothing moves; use a shorter step",
                            step, seconds));
  }
  constexpr double kMostRatio = 1e4;
  if (const double ratio = mass_ratio(scene); ratio > kMostRatio) {
    warn(scene,
         fmt::format("/solver/method: masses of 1 : {:.2g} under gravity: overlap lets heavy "
                     "balls sink into light ones beyond 1 : 10000; use method event",
                     ratio));
  }
}

}  // namespace carom
