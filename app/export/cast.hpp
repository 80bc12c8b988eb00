#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// An asciicast, version 2, as asciinema plays it.
/// Source: asciinema, asciicast file format, version 2.
class CastText {
 public:
  CastText(int columns, int rows, const std::string& title);

  /// The first line of the file.
  [[nodiscard]] const std::string& header() const { return header_; }
  /// What goes to the terminal at `seconds`, as a line; nothing for no bytes.
  static std::string output(double seconds, std::string_view bytes);
  /// The window has another size from then on.
  static std::string resize(double seconds, int columns, int rows);

 private:
  std::string header_;
};

/// The text that makes a terminal show one picture after another: only cells that have changed.
class PictureChanges {
 public:
  /// `picture`: rows of text, each with its end of line; characters that take one cell.
  [[nodiscard]] std::string next(const std::string& picture);
  /// After the last picture.
  static std::string end();

 private:
  std::vector<std::vector<std::string>> shown_;  // rows of cells; empty: nothing yet
};

}  // namespace carom
