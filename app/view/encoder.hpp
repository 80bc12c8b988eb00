#pragma once

#include <string>

#include "view/canvas.hpp"
#include "view/palette.hpp"

namespace carom {

/// What a terminal is sent so that it shows a picture: only the cells that differ from what it
/// shows already, in few bytes.
///
/// Runs of cells are sent in the order of rows, or gathered by colour, whichever is shorter; the
/// cursor is moved by the shortest sequence.
/// REQUIRES: the terminal takes ANSI (ECMA-48)
/// sequences, and UTF-8 where the picture has more than ASCII.
class Encoder {
 public:
  explicit Encoder(Palette palette) : palette_(palette) {}

  /// The bytes from what is shown to `canvas`, which is shown from then on; empty if it is already.
  /// The cursor is left anywhere, and attributes as plain text has them.
  std::string show(const Canvas& canvas);
  /// What is shown is not known any more: the next picture is sent whole, on a cleared screen.
  void forget() { shown_ = Canvas(); }
  void set_palette(Palette palette) {
    palette_ = palette;
    forget();
  }
  [[nodiscard]] const Palette& palette() const { return palette_; }

 private:
  Palette palette_;
  Canvas shown_;
};

/// Adds a character as UTF-8.
void append_utf8(char32_t character, std::string& bytes);

}  // namespace carom
