#pragma once

#include <stdexcept>

#include "accuracy/runner.hpp"

namespace carom::accuracy {

/// A run that would take far longer than its share.
class TooLong : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Times the way of `row` on a crew: after a warm-up the median of some repeats, and their spread.
/// A run is timed from its start to its end, without making the simulation and its threads.
/// Errors: TooLong; what Simulation throws.
void time_runs(AccuracyRow& row, const Scenario& scenario, const AccuracyCrew& crew, double share);

}  // namespace carom::accuracy
