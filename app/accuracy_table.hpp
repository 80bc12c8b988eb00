#pragma once

#include <string>

#include "carom/accuracy.hpp"

namespace carom {

/// What a study found, as a person reads it: a line for each run, the best choices marked.
std::string to_table(const AccuracyStudy& study);

/// A run as it is called there, as in "overlap, 1/240 s".
std::string run_name(const AccuracyRow& row);

/// "12.3 ms"; three digits and the unit that fits.
std::string duration_text(double seconds);

/// "1/240 s" where that is what it is, else in seconds.
std::string step_text(double step);

/// "2.1e-14", or "0".
std::string error_text(double error);

}  // namespace carom
