#pragma once

#include <memory>
#include <string>

#include "view/palette.hpp"
#include "view/signals.hpp"
#include "view/terminal_info.hpp"
#include "view/user_interface.hpp"

namespace carom {

/// The terminal.
/// REQUIRES: `info.problem` is empty; one at a time.
///
/// Output never holds up the program: where the terminal takes none (it was stopped by Ctrl-S, or
/// its window does not read), pictures are left out until it does, and keys and signals work on.
/// Holds: on destruction, and where the program crashes, the terminal is as it was found.
/// Errors: std::runtime_error where the terminal cannot be used.
class TerminalScreen : public UserInterface {
 public:
  struct Options {
    bool colors = true;
    bool mouse = false;  ///< whether mouse reports come as events
    Background background = Background::any;
  };

  /// `signals` outlives the screen.
  TerminalScreen(Signals& signals, const TerminalInfo& info, const Options& options);
  ~TerminalScreen() override;

  [[nodiscard]] Size size() const override;
  void show(const Canvas& canvas) override;
  Event wait_until(Instant deadline) override;
  [[nodiscard]] Instant now() const override { return std::chrono::steady_clock::now(); }
  [[nodiscard]] bool unicode() const override;
  void set_title(const std::string& title) override;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom
