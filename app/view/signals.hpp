#pragma once

#include <csignal>
#include <optional>

namespace carom {

/// Holds back the signals that a player answers in its own time, and hands them out one by one: all
/// that ask it to end, to stop, to go on, or tell of a new size.
///
/// Holds: from construction on they are blocked in this thread and in those it starts, so that no
/// thread is interrupted at a bad moment; on destruction everything is as before.
class Signals {
 public:
  Signals();
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  /// Readable while a signal is waiting.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// The next signal that is waiting.
  std::optional<int> next();
  /// Lets `signal` do to this process what it does by default, as the terminal's stop key wants.
  static void obey(int signal);

 private:
  sigset_t before_{};
  int descriptor_ = -1;
};

}  // namespace carom
