#include "accuracy/timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace carom::accuracy {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kWarmUp = 1.0 / 16;  // of the run
constexpr double kFarTooLong = 4;     // shares
constexpr std::size_t kFewest = 3;    // repeats, of which the middle one counts
constexpr std::size_t kMost = 25;
constexpr double kEnough = 0.05;  // of a share, or seconds: no more repeats after it

double seconds_of(Runner& runner, double until) {
  const auto start = Clock::now();
  runner.advance_to(until);
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The value below which this part of them lies, in between by proportion.
double quantile(const std::vector<double>& sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= sorted.size()) return sorted.back();
  const double beyond = place - static_cast<double>(below);
  return sorted[below] * (1 - beyond) + sorted[below + 1] * beyond;
}

}  // namespace

void time_runs(AccuracyRow& row, const Scenario& scenario, const AccuracyCrew& crew, double share) {
  const Way way{row.method, row.step, row.digits};
  {
    Runner warm_up(scenario, way, crew);
    const double whole = seconds_of(warm_up, scenario.end * kWarmUp) / kWarmUp;
    if (whole > kFarTooLong * share) {
      throw TooLong(fmt::format("would take about {:.3g} s, its share is {:.3g} s", whole, share));
    }
  }
  std::vector<double> seconds;
  double spent = 0;
  while (seconds.size() < kFewest ||
         (spent < kEnough * std::min(share, 1.0) && seconds.size() < kMost)) {
    Runner runner(scenario, way, crew);
    row.workers = runner.simulation().workers();
    seconds.push_back(seconds_of(runner, scenario.end));
    spent += seconds.back();
  }
  std::sort(seconds.begin(), seconds.end());
  row.seconds = quantile(seconds, 0.5);
  row.quartiles = {quantile(seconds, 0.25), quantile(seconds, 0.75)};
  row.fastest = seconds.front();
  row.slowest = seconds.back();
  row.repeats = seconds.size();
}

}  // namespace carom::accuracy
