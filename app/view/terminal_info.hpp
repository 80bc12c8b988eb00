#pragma once

#include <string>

namespace carom {

/// Why the terminal that TERM names cannot show moving balls; empty if it can.
std::string terminal_problem();

/// Keeps curses, once it has started, from asking the terminal to repeat a character: libvterm, and
/// so the terminals inside some editors, then wrap the line one column early.
void avoid_repetition();

}  // namespace carom
