#pragma once

#include <string>
#include <vector>

#include "carom/impact.hpp"

namespace carom {

/// The first line of a file of events.
std::string events_header();

/// Events as lines of CSV.
std::string events_lines(const std::vector<Impact>& impacts);

}  // namespace carom
