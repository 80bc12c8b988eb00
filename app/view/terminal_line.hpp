#pragma once

#include <termios.h>

#include <string>
#include <string_view>

namespace carom {

/// The two ends of a terminal: its line discipline, and bytes to it that never hold up the program.
///
/// Threads: the control thread only.
/// Errors: std::runtime_error from the constructor where standard input is no terminal.
class TerminalLine {
 public:
  TerminalLine();
  ~TerminalLine();
  TerminalLine(const TerminalLine&) = delete;
  TerminalLine& operator=(const TerminalLine&) = delete;

  [[nodiscard]] const termios& before() const { return before_; }
  [[nodiscard]] int output() const { return output_; }

  /// Keys come one by one and are not echoed.
  void take_over();
  void give_back();

  /// Sends bytes, as many as the terminal takes now; the rest waits for `flush`.
  void send(std::string_view bytes);
  void flush();
  [[nodiscard]] bool blocked() const { return !waiting_.empty(); }
  /// Drops what waits and sends `bytes`, as the last thing that the terminal must get; sets output
  /// going again that was stopped.  Takes a second at the longest.
  void send_last(std::string_view bytes);
  [[nodiscard]] bool gone() const { return gone_; }
  void set_gone() { gone_ = true; }

 private:
  termios before_{};
  int output_ = -1;
  std::string waiting_;
  bool gone_ = false;
};

}  // namespace carom
