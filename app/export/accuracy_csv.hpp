#pragma once

#include <string>

#include "carom/accuracy.hpp"

namespace carom {

/// The runs of a study as comma-separated values: a line of names, then one for each run; what it
/// was measured on stands in every line.  Empty: there is no such number.
std::string to_csv(const AccuracyStudy& study);

}  // namespace carom
