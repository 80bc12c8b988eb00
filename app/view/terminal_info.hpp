#pragma once

#include <string>

#include "view/palette.hpp"

namespace carom {

/// The terminal as TERM, COLORTERM and the locale tell it.
struct TerminalInfo {
  std::string name;     ///< the description in use
  std::string remark;   ///< a line to say, where it is not the one that TERM names
  std::string problem;  ///< why it cannot show moving balls; empty if it can
  Colors colors = Colors::none;
  bool unicode = false;
};

/// Loads the description.  Of a terminal that is not known here, that of xterm-256color, which
/// nearly all understand.
TerminalInfo load_terminal_info();

/// A capability that is text, by its terminfo name, as of the description loaded; without padding.
std::string capability(const char* name);

/// Whether a terminal of this name has a window with a title.
bool has_window(const std::string& term);

}  // namespace carom
