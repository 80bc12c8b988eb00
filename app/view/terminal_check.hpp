#pragma once

#include <string>

namespace carom {

/// Why the terminal that TERM names cannot show moving balls; empty if it can.
std::string terminal_problem();

}  // namespace carom
