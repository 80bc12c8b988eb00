#pragma once

#include <termios.h>

#include <string>

namespace carom {

/// Gives the terminal back where the program crashes: a signal handler that writes what is to be
/// written and sets the line discipline, then lets the signal do what it would have done.
///
/// Threads: made and destroyed by the control thread; the handler runs on any.  One at a time.
class TerminalRescue {
 public:
  TerminalRescue(int descriptor, const termios& before, const std::string& leave);
  ~TerminalRescue();
  TerminalRescue(const TerminalRescue&) = delete;
  TerminalRescue& operator=(const TerminalRescue&) = delete;
};

}  // namespace carom
