#pragma once

#include <string_view>

namespace carom {

/// The description of a terminal as the environment variable TERMINFO may hold it, made when the
/// program was built; null for a terminal that is not built in.
const char* built_in_terminal(std::string_view name);

}  // namespace carom
