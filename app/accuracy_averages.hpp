#pragma once

#include <string>

#include "carom/accuracy.hpp"

namespace carom {

/// The averages of every run beside those of the reference; empty where none were asked for.
std::string to_average_table(const AccuracyStudy& study);

/// What each average costs with each method; empty where none were asked for.
std::string to_average_sentences(const AccuracyStudy& study);

}  // namespace carom
