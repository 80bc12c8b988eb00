#include "accuracy/truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "carom/scene_file.hpp"

namespace carom::accuracy {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kJudgeCostAfter = 0.5;  // seconds
constexpr double kGrown = 1e3;           // in roundings: from here on growth can be told

/// Digits of a reference, and of the run that checks it.
struct Pair {
  int digits;
  int checked;
};
constexpr std::array kPairs{Pair{100, 50}, Pair{50, 34}, Pair{34, 16}, Pair{16, 16}};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What a pair will have taken when it ends, or parts: what rounding does to the narrow run grows
/// by the same factor again and again, as chaos has it.
double foreseen(double spent, double time, double end, double apart, const Pair& pair,
                double smallest_radius) {
  const double rounding = std::pow(10.0, -pair.checked) * smallest_radius;
  if (apart > rounding * kGrown) {
    const double grown = std::log(apart / rounding);
    const double until_lost = time * std::log(kLost * smallest_radius / rounding) / grown;
    end = std::min(end, until_lost);
  }
  return spent * end / time;
}

/// Both runs side by side; fills in the truth, or says why not.
std::optional<std::string> compute(Truth& truth, const Pair& pair, const Scenario& scenario,
                                   const Samples& samples, double smallest_radius, double allowance,
                                   const PartDone& told) {
  truth = {};
  AccuracyReference& reference = truth.reference;
  reference.digits = pair.digits;
  reference.checked_digits = pair.checked;
  const auto started = Clock::now();
  Runner wide(scenario, {Method::event, std::nullopt, pair.digits});
  Runner narrow(scenario, {Method::event, std::nullopt, pair.checked});
  for (std::size_t sample = 1; sample <= samples.count() && !reference.holds_until; ++sample) {
    const double time = samples.time(sample);
    wide.advance_to(time);
    narrow.advance_to(time);
    truth.at_sample.push_back(Places::of(wide.simulation()));
    const double apart =
        distance(truth.at_sample.back(), Places::of(narrow.simulation()), scenario.start.box);
    reference.difference = std::max(reference.difference, apart);
    if (apart > kLost * smallest_radius) reference.holds_until = time;
    const double spent = seconds_since(started);
    if (spent < kJudgeCostAfter) continue;
    const double whole = foreseen(spent, time, scenario.end, apart, pair, smallest_radius);
    told(std::min(1.0, spent / whole));
    if (whole > allowance) {
      return fmt::format(
          "{} digits, checked with {}, would take about {:.0f} s and may take {:.0f} "
          "s; give a shorter --time or a larger --share",
          pair.digits, pair.checked, whole, allowance);
    }
  }
  const Measurements measured = wide.simulation().measure();
  reference.ball_ball = measured.ball_ball;
  reference.ball_wall = measured.ball_wall;
  reference.seconds = seconds_since(started);
  if (!reference.holds_until) truth.energy = measured.energy_final;
  return std::nullopt;
}

}  // namespace

Truth find_truth(const Scenario& scenario, const Samples& samples, double smallest_radius,
                 double allowance, const PartDone& told) {
  Truth truth;
  std::string why;
  for (const Pair& pair : kPairs) {
    try {
      const auto failure =
          compute(truth, pair, scenario, samples, smallest_radius, allowance, told);
      if (!failure) return truth;
      why = *failure;
    } catch (const SceneError& refused) {
      const Problem& problem = refused.problems().front();
      why = problem.place + ": " + problem.message;
    } catch (const CommandError& refused) {
      why = std::string("a command of the script is refused: ") + refused.what();
      break;
    }
  }
  throw NoReference("no reference to hold the runs against: " + why);
}

void refine_truth(Truth& truth, const Scenario& scenario, const Samples& samples,
                  const PartDone& told) {
  Runner runner(scenario, {truth.reference.method, truth.reference.step, truth.reference.digits});
  std::size_t done = 0;
  for (auto& [fine, places] : truth.at_fine) {
    runner.advance_to(samples.fine_time(fine));
    places = Places::of(runner.simulation());
    told(static_cast<double>(++done) / static_cast<double>(truth.at_fine.size()));
  }
}

}  // namespace carom::accuracy
