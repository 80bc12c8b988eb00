#include "accuracy/truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "carom/scene_file.hpp"

namespace carom::accuracy {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kJudgeCostAfter = 0.5;  // seconds
constexpr double kShortestStep = kLongestStep / 8192;
constexpr int kNoBetter = 2;    // steps in a row that come no nearer: rounding has the word
constexpr double kGrown = 1e3;  // in roundings: from here on growth can be told

/// Digits of a reference, and of the run that checks it.
struct Pair {
  int digits;
  int checked;
};
constexpr std::array kPairs{Pair{100, 50}, Pair{50, 34}, Pair{34, 16}};

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
                                   const Told& told) {
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
    truth.at_sample.push_back(wide.simulation().exact_positions());
    const double apart = largest_distance(
        truth.at_sample.back(), narrow.simulation().exact_positions(), scenario.start.box);
    reference.difference = std::max(reference.difference, apart);
    if (apart > kLost * smallest_radius) reference.holds_until = time;
    const double spent = seconds_since(started);
    const double whole = foreseen(spent, time, scenario.end, apart, pair, smallest_radius);
    told(spent, whole);
    if (spent < kJudgeCostAfter) continue;
    if (whole > allowance) {
      return fmt::format(
          "{} digits, checked with {}, would take about {:.0f} s and the time limit is {:.0f} "
          "s; give a shorter --time or a larger --share",
          pair.digits, pair.checked, whole, allowance);
    }
  }
  const Measurements measured = wide.simulation().measure();
  reference.ball_ball = measured.ball_ball;
  reference.ball_wall = measured.ball_wall;
  reference.seconds = seconds_since(started);
  return std::nullopt;
}

Truth by_digits(const Scenario& scenario, const Samples& samples, double smallest_radius,
                double allowance, const Told& told) {
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
    }
  }
  throw NoReference(why);
}

/// A run in steps; as far as the one before it goes, where there is one, and was not lost.
Truth in_steps(double step, const Truth* before, const Scenario& scenario, const Samples& samples,
               double smallest_radius, const std::function<void()>& told) {
  Truth truth;
  truth.reference.digits = truth.reference.checked_digits = 16;
  truth.reference.step = step;
  Runner runner(scenario, {Method::event, step, 16});
  const std::size_t count = before == nullptr ? samples.count() : before->known();
  const auto started = Clock::now();
  for (std::size_t sample = 1; sample <= samples.count() && !truth.reference.holds_until;
       ++sample) {
    told();
    runner.advance_to(samples.time(sample));
    truth.at_sample.push_back(runner.simulation().exact_positions());
    if (before == nullptr || sample > count) continue;
    const double apart =
        largest_distance(truth.at_sample.back(), before->at_sample[sample - 1], scenario.start.box);
    truth.reference.difference = std::max(truth.reference.difference, apart);
    if (apart > kLost * smallest_radius) truth.reference.holds_until = samples.time(sample);
  }
  const Measurements measured = runner.simulation().measure();
  truth.reference.ball_ball = measured.ball_ball;
  truth.reference.ball_wall = measured.ball_wall;
  truth.reference.seconds = seconds_since(started);
  return truth;
}

/// How near two runs are to each other: longer to be lost is nearer.
bool is_nearer(const AccuracyReference& one, const AccuracyReference& other) {
  const double never = std::numeric_limits<double>::infinity();
  const double one_until = one.holds_until.value_or(never);
  const double other_until = other.holds_until.value_or(never);
  if (one_until != other_until) return one_until > other_until;
  return one.difference < other.difference;
}

Truth by_steps(const Scenario& scenario, const Samples& samples, double smallest_radius,
               double allowance, const Told& told) {
  // No step of the sequence of steps, so that none is compared with itself.
  double step = kLongestStep * 2 / 3;
  double spent = 0;
  double foreseen = 0;
  const auto tell = [&] { told(spent, std::max(spent, foreseen)); };
  Truth coarse = in_steps(step, nullptr, scenario, samples, smallest_radius, tell);
  std::optional<Truth> best;
  spent = coarse.reference.seconds;
  for (int no_better = 0; no_better < kNoBetter && step > kShortestStep;) {
    const double next = 2 * coarse.reference.seconds;
    if (best && spent + next > allowance) break;
    foreseen = std::min(spent + 3 * next, std::max(allowance, spent));
    tell();
    step /= 2;
    Truth fine = in_steps(step, &coarse, scenario, samples, smallest_radius, tell);
    spent += fine.reference.seconds;
    fine.reference.checked_step = 2 * step;
    const bool nearer = !best || is_nearer(fine.reference, best->reference);
    no_better = nearer ? 0 : no_better + 1;
    // The one before is wanted whole for the next comparison, and no longer.
    coarse = std::move(fine);
    if (nearer) best = coarse;
    if (coarse.reference.holds_until && coarse.known() < samples.count()) {
      coarse = in_steps(step, nullptr, scenario, samples, smallest_radius, tell);
    }
  }
  best->reference.seconds = spent;
  return std::move(*best);
}

}  // namespace

Truth find_truth(const Scenario& scenario, const Samples& samples, double smallest_radius,
                 double allowance, const Told& told) {
  const bool steps = scenario.start.effects.attraction.has_value();
  std::string why;
  try {
    return (steps ? by_steps : by_digits)(scenario, samples, smallest_radius, allowance, told);
  } catch (const SceneError& refused) {
    const Problem& problem = refused.problems().front();
    why = problem.place + ": " + problem.message;
  } catch (const CommandError& refused) {
    why = std::string("a command of the script is refused: ") + refused.what();
  } catch (const NoReference& refused) {
    why = refused.what();
  }
  throw NoReference("no reference to compare the runs with: " + why);
}

void refine_truth(Truth& truth, const Scenario& scenario, const Samples& samples,
                  const Told& told) {
  Runner runner(scenario, {truth.reference.method, truth.reference.step, truth.reference.digits});
  const auto started = Clock::now();
  std::size_t done = 0;
  for (auto& [fine, places] : truth.at_fine) {
    runner.advance_to(samples.fine_time(fine));
    places = runner.simulation().exact_positions();
    const double spent = seconds_since(started);
    told(spent, spent / static_cast<double>(++done) * static_cast<double>(truth.at_fine.size()));
  }
}

}  // namespace carom::accuracy
