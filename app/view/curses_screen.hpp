#pragma once

#include <memory>

#include "view/signals.hpp"
#include "view/user_interface.hpp"

namespace carom {

/// The terminal, by curses.
/// REQUIRES: `terminal_problem()` is empty; one at a time.
///
/// Holds: on destruction, however it comes about, the terminal is as it was found.
/// Errors: std::runtime_error where the terminal cannot be used.
class CursesScreen : public UserInterface {
 public:
  /// `signals` outlives the screen.
  CursesScreen(Signals& signals, bool colors);
  ~CursesScreen() override;

  [[nodiscard]] Size size() const override;
  void show(const Canvas& canvas) override;
  Event wait_until(Instant deadline) override;
  [[nodiscard]] Instant now() const override { return std::chrono::steady_clock::now(); }

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom
