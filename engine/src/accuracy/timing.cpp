#include "accuracy/timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <vector>

namespace carom::accuracy {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kWarmUp = 1.0 / 16;  // of the run
constexpr std::size_t kFewest = 3;    // repeats, of which the middle one counts
constexpr std::size_t kMost = 25;
constexpr double kEnough = 0.05;  // of a limit, or seconds: no more repeats after it
constexpr double kPiece = 0.25;   // seconds of a long run after which it can be stopped
constexpr double kMostPieces = 256;

double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  constexpr double kNano = 1e-9;
  return static_cast<double>(now.tv_sec) + kNano * static_cast<double>(now.tv_nsec);
}

/// `pieces`: in which the way is gone, so that it can be stopped in between.
Spent run(Runner& runner, double until, double pieces, const Stopped& stopped) {
  const double cpu = cpu_now();
  const auto start = Clock::now();
  for (double piece = 1; piece < pieces; ++piece) {
    runner.advance_to(until * piece / pieces);
    if (stopped && stopped()) throw StopAsked();
  }
  runner.advance_to(until);
  return {std::chrono::duration<double>(Clock::now() - start).count(), cpu_now() - cpu};
}

}  // namespace

Spent advance(Runner& runner, double until) {
  return run(runner, until, 1, {});
}

double quantile(const std::vector<double>& sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= sorted.size()) return sorted.back();
  const double beyond = place - static_cast<double>(below);
  return sorted[below] * (1 - beyond) + sorted[below + 1] * beyond;
}

double seconds_of_timing(double run, double limit) {
  const double enough = kEnough * std::min(limit, 1.0);
  const double repeats = std::max(static_cast<double>(kFewest) * run,
                                  std::min(enough, static_cast<double>(kMost) * run));
  return kWarmUp * run + repeats;
}

void time_runs(AccuracyRow& row, const Scenario& scenario, const AccuracyCrew& crew, double limit,
               const Stopped& stopped) {
  const Way way{row.method, row.step, row.digits};
  double pieces = 1;
  {
    Runner warm_up(scenario, way, crew);
    const double whole = run(warm_up, scenario.end * kWarmUp, 1, stopped).wall / kWarmUp;
    if (whole > kFarTooLong * limit) {
      throw TooLong(
          fmt::format("would take about {:.3g} s, its time limit is {:.3g} s", whole, limit));
    }
    pieces = std::min(std::ceil(whole / kPiece), kMostPieces);
  }
  std::vector<double> seconds;
  std::vector<double> cpu;
  double spent = 0;
  while (seconds.size() < kFewest ||
         (spent < kEnough * std::min(limit, 1.0) && seconds.size() < kMost)) {
    if (stopped && stopped()) throw StopAsked();
    Runner runner(scenario, way, crew);
    row.workers = runner.simulation().workers();
    const Spent once = run(runner, scenario.end, pieces, stopped);
    seconds.push_back(once.wall);
    cpu.push_back(once.cpu);
    spent += once.wall;
  }
  std::sort(seconds.begin(), seconds.end());
  std::sort(cpu.begin(), cpu.end());
  row.seconds = quantile(seconds, 0.5);
  row.cpu_seconds = quantile(cpu, 0.5);
  row.quartiles = {quantile(seconds, 0.25), quantile(seconds, 0.75)};
  row.fastest = seconds.front();
  row.slowest = seconds.back();
  row.repeats = seconds.size();
}

}  // namespace carom::accuracy
