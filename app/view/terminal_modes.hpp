#pragma once

#include <string>

namespace carom {

/// What a terminal is told when a player takes it over, and when it gives it back.
struct TerminalModes {
  std::string enter;
  std::string again;  ///< of `enter`, what may be said twice
  std::string leave;  ///< undoes all of `enter`, whatever state the output was cut off in
};

/// For the terminal that TERM names.
/// REQUIRES: its description has been loaded.
TerminalModes terminal_modes(const std::string& term, bool mouse);

}  // namespace carom
