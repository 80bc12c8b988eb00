#pragma once

#include <chrono>
#include <string>

#include "view/canvas.hpp"

namespace carom {

using Instant = std::chrono::steady_clock::time_point;

/// Keys that are no characters, as `Event::value` has them beside the characters.
namespace key {
inline constexpr int kTab = '\t';
inline constexpr int kEnter = '\r';
inline constexpr int kEscape = 0x1B;
inline constexpr int kBackspace = 0x7F;
inline constexpr int kUp = 0x110000;
inline constexpr int kDown = 0x110001;
inline constexpr int kRight = 0x110002;
inline constexpr int kLeft = 0x110003;
inline constexpr int kOther = 0;  ///< one that this program has no name for, or with Alt or Ctrl
}  // namespace key

/// What the mouse does over a cell.
struct Mouse {
  enum class Action { press, drag, release, wheel_up, wheel_down };

  Action action = Action::press;
  int button = 0;  ///< 0 left, 1 middle, 2 right
  int column = 0;
  int row = 0;

  bool operator==(const Mouse&) const = default;
};

/// What a person, or the system in their name, asks of the player.
struct Event {
  enum class Kind {
    none,     ///< nothing happened until the time given
    key,      ///< `value` is its character, or one of `key`
    mouse,    ///< `mouse` says what
    pasted,   ///< text was pasted, which is not told
    resized,  ///< the screen has another size now
    resumed,  ///< the program was stopped and goes on: time has passed unseen
    ended     ///< `value` is the signal that asks the program to end
  };

  Kind kind = Kind::none;
  int value = 0;
  Mouse mouse = {};

  bool operator==(const Event&) const = default;
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

  /// Whether characters beyond ASCII can be shown.
  [[nodiscard]] virtual bool unicode() const { return false; }
  /// What the window is called.
  virtual void set_title(const std::string& /*title*/) {}
};

}  // namespace carom
