#pragma once

#include <functional>
#include <stdexcept>
#include <vector>

#include "accuracy/runner.hpp"

namespace carom::accuracy {

/// A run that would take far longer than its time limit.
class TooLong : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Asked often; true: give up.
using Stopped = std::function<bool()>;

/// The study is asked to end.
class StopAsked : public std::runtime_error {
 public:
  StopAsked() : std::runtime_error("stopped") {}
};

/// What computing has taken.
struct Spent {
  double wall = 0;
  double cpu = 0;  ///< of all threads
};

/// Moves on to `until`.
Spent advance(Runner& runner, double until);

/// The value below which this part of some sorted values lies, in between by proportion.
double quantile(const std::vector<double>& sorted, double part);

inline constexpr double kFarTooLong = 4;  ///< time limits: such runs are given up

/// Times the way of `row` on a crew: after a warm-up the median of some repeats, and their spread.
/// A run is timed from its start to its end, without making the simulation and its threads.
/// Errors: TooLong; StopAsked; what Simulation throws.
void time_runs(AccuracyRow& row, const Scenario& scenario, const AccuracyCrew& crew, double limit,
               const Stopped& stopped);

/// What `time_runs` takes for a run of so many seconds.
double seconds_of_timing(double run, double limit);

}  // namespace carom::accuracy
