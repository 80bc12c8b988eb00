#pragma once

#include <string>

#include "carom/report.hpp"

namespace carom {

/// What a headless run did, as a person reads it.
std::string to_summary(const Report& report);

}  // namespace carom
