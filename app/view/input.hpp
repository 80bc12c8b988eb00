#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "view/user_interface.hpp"

namespace carom {

/// Reads what a terminal sends: keys, mouse reports, pasted text.
///
/// An escape sequence is one event, whole, whatever it is: none of its characters is a key.  One
/// that is unknown, or a key with Alt, is `key::kOther`.  Text between the marks of bracketed paste
/// is one event and otherwise ignored.  Bytes that are no sequence yet wait for the rest.
///
/// Source: ECMA-48 5.4 and 5.6 (control sequences and strings); xterm, "Control Sequences" (SS3,
/// mouse modes 1000 and 1006, bracketed paste).
class Input {
 public:
  void feed(std::string_view bytes);
  /// Nothing more came for a while: an escape character that waits is the key Escape, a sequence
  /// that is cut off is an unknown key.
  void settle();

  [[nodiscard]] std::optional<Event> next();
  /// Whether some bytes wait for the rest of their sequence.
  [[nodiscard]] bool waiting() const { return !bytes_.empty(); }

 private:
  [[nodiscard]] std::size_t take_one();
  [[nodiscard]] std::size_t take_escape();
  [[nodiscard]] std::size_t take_control_sequence(std::size_t begin);
  [[nodiscard]] std::size_t take_string();
  [[nodiscard]] std::size_t take_character();
  void act_on(std::string_view parameters, char last);
  void report_mouse(std::string_view parameters, char last);
  void key(int value) { events_.push_back({Event::Kind::key, value, {}}); }

  std::string bytes_;
  std::deque<Event> events_;
  bool pasting_ = false;
};

}  // namespace carom
