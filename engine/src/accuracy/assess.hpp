#pragma once

#include "accuracy/runner.hpp"
#include "accuracy/samples.hpp"
#include "accuracy/timing.hpp"
#include "accuracy/truth.hpp"

namespace carom::accuracy {

/// Between which samples a run was lost.
struct Loss {
  std::size_t before = 0;  ///< the last one where it was not; 0: the start
  std::size_t seen = 0;    ///< the first one where it was
};

/// Errors of all: StopAsked; what Simulation throws.

/// Runs a way and holds it against the truth: fills in the errors, counts and, to a sample, the
/// horizon of `row`.
std::optional<Loss> assess(AccuracyRow& row, const Scenario& scenario, const Samples& samples,
                           const Truth& truth, double smallest_radius, const Stopped& stopped);

/// The fine numbers in between at which the run can be compared.
std::vector<std::uint64_t> fine_numbers(const AccuracyRow& row, const Loss& loss,
                                        const Samples& samples);

/// Runs the way of `row` again and finds the horizon among the fine numbers of `truth`.
void refine_horizon(AccuracyRow& row, const Loss& loss, const Scenario& scenario,
                    const Samples& samples, const Truth& truth, double smallest_radius,
                    const Stopped& stopped);

}  // namespace carom::accuracy
