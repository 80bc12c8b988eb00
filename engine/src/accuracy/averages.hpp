#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "accuracy/runner.hpp"
#include "carom/accuracy.hpp"

namespace carom::accuracy {

/// The averages of one run, by observable; absent where it has no such average, as a mean free path
/// without collisions.
using Averages = std::vector<std::optional<double>>;

/// Runs a way and averages over the time after the first fifth, in which the start is forgotten.
///
/// Temperature, pressure and Z as in FluidMeter; the collision rate is that of a ball, two for each
/// collision of two; the mean free path is the mean speed over that rate.
/// `told`: often, with the part of the time that is simulated.
/// Errors: what `told` and Simulation throw.
Averages averages_of(const std::vector<Observable>& observables, const Scenario& scenario,
                     const Way& way, const AccuracyCrew& crew,
                     const std::function<void(double part)>& told);

/// The mean over runs with its standard error; absent where a run has no such average.
std::vector<std::optional<MeanAndError>> mean_over(const std::vector<Averages>& runs);

}  // namespace carom::accuracy
