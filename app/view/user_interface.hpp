#pragma once

#include <chrono>

#include "view/canvas.hpp"

namespace carom {

using Instant = std::chrono::steady_clock::time_point;

/// What a person, or the system in their name, asks of the player.
struct Event {
  enum class Kind {
    none,     ///< nothing happened until the time given
    key,      ///< `value` is its character
    resized,  ///< the screen has another size now
    resumed,  ///< the program was stopped and goes on: time has passed unseen
    ended     ///< `value` is the signal that asks the program to end
  };

  Kind kind = Kind::none;
  int value = 0;
};

/// Where a person watches and presses keys: a terminal, or a stand-in that needs none.  It also
/// tells the time, so that a stand-in can tell its own.
class UserInterface {
 public:
  struct Size {
    int columns = 0;
    int rows = 0;
  };

  UserInterface() = default;
  virtual ~UserInterface() = default;
  UserInterface(const UserInterface&) = delete;
  UserInterface& operator=(const UserInterface&) = delete;

  [[nodiscard]] virtual Size size() const = 0;
  virtual void show(const Canvas& canvas) = 0;
  /// The next event; waits for it until `deadline` at the longest, and looks once even where that
  /// has passed.
  virtual Event wait_until(Instant deadline) = 0;
  [[nodiscard]] virtual Instant now() const = 0;
};

}  // namespace carom
