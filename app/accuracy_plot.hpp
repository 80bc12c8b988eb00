#pragma once

#include <string>

#include "carom/accuracy.hpp"

namespace carom {

/// Error of position, or the horizon where runs are judged by that, against time per simulated
/// second, both logarithmic, in characters: a mark for each run, a line for each method, the best
/// choices as capitals.  Empty where there is nothing to draw.
std::string to_plot(const AccuracyStudy& study);

}  // namespace carom
