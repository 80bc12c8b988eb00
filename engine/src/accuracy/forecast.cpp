#include "accuracy/forecast.hpp"

#include <algorithm>
#include <chrono>
#include <exception>

#include "accuracy/samples.hpp"
#include "accuracy/timing.hpp"

namespace carom::accuracy {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPilotSeconds = 0.05;
constexpr double kPilotPieces = 64;       // of the scene's time
constexpr double kShortPilot = 1.0 / 16;  // of the longest step
// Seconds of a run in many digits over those of one in double precision, where neither is known.
constexpr double kManyDigits = 60;
constexpr double kNarrow = 0.45;  // of the reference: the narrower of its two runs

/// A run until its part of the time is over or it has taken long enough, extrapolated to its end.
double pilot(const Scenario& scenario, const Way& way) {
  try {
    Runner runner(scenario, way);
    const auto start = Clock::now();
    for (double piece = 1; piece <= kPilotPieces; ++piece) {
      runner.advance_to(scenario.end * piece / kPilotPieces);
      const double spent = std::chrono::duration<double>(Clock::now() - start).count();
      if (spent > kPilotSeconds || piece == kPilotPieces) return spent / piece * kPilotPieces;
    }
  } catch (const std::exception&) {  // the row will say why
  }
  return 0;
}

}  // namespace

Forecast::Forecast(const Scenario& scenario, double limit) : limit_(limit) {
  const bool steps = scenario.start.effects.attraction.has_value();
  for (const Method method : {Method::event, Method::overlap}) {
    if (method == Method::event && !steps) {
      exact_ = pilot(scenario, {method, std::nullopt, 16});
      continue;
    }
    for (const double step : {kLongestStep, kLongestStep * kShortPilot}) {
      steps_[method][step] = pilot(scenario, {method, step, 16});
    }
  }
}

void Forecast::learn(const AccuracyRow& row) {
  if (!row.failure.empty()) return;
  if (row.step) {
    Steps& steps = steps_[row.method];
    // What was measured is worth more than a pilot.
    std::erase_if(steps, [&](const auto& known) { return known.first < *row.step; });
    steps[*row.step] = row.seconds;
  } else {
    digits_[row.digits] = row.seconds;
  }
}

double Forecast::reference() const {
  if (steps_.contains(Method::event)) return 3 * run({Method::event, kLongestStep / 64, 16});
  return 2 * kManyDigits * exact_;
}

double Forecast::extrapolated(const Steps& steps, double step) {
  if (steps.empty()) return 0;
  const auto last = std::prev(steps.end());
  if (steps.size() == 1) return last->second * last->first / step;
  const auto before = std::prev(last);
  const double per_step = (last->second - before->second) / (1 / last->first - 1 / before->first);
  return std::max(last->second, last->second + per_step * (1 / step - 1 / last->first));
}

double Forecast::run(const Way& way) const {
  if (way.step) {
    const auto steps = steps_.find(way.method);
    return steps == steps_.end() ? 0 : extrapolated(steps->second, *way.step);
  }
  const auto known = digits_.find(way.digits);
  if (known != digits_.end()) return known->second;
  if (way.digits == 16) return exact_;
  return reference_ ? kNarrow * reference_->first : kManyDigits * exact_;
}

double Forecast::with_repeats(double run) const {
  return run + seconds_of_timing(run, limit_);
}

}  // namespace carom::accuracy
