#pragma once

#include <vterm.h>

#include <cstdint>
#include <string>

namespace carom::support {

/// A cell as a terminal shows it; colours as a palette tells them.
struct ShownCell {
  char32_t character = U' ';
  bool bold = false;
  bool reverse = false;
  std::uint32_t fore = 0xFFFFFFFF;
  std::uint32_t back = 0xFFFFFFFF;
};

/// A row of a screen, with ? for what is not ASCII.
inline std::string row_of(VTermScreen* screen, int row, int columns) {
  std::string line;
  for (int column = 0; column < columns; ++column) {
    VTermScreenCell cell;
    if (vterm_screen_get_cell(screen, {row, column}, &cell) == 0) break;
    const auto character = cell.chars[0];
    line += character == 0 ? ' ' : character < 0x80 ? static_cast<char>(character) : '?';
  }
  return line;
}

/// The screen of a terminal without a program in it: libvterm, fed with bytes.
class VtermScreen {
 public:
  VtermScreen(int columns, int rows)
      : columns_(columns), rows_(rows), vterm_(vterm_new(rows, columns)) {
    vterm_set_utf8(vterm_, 1);
    screen_ = vterm_obtain_screen(vterm_);
    vterm_screen_reset(screen_, 1);
  }
  ~VtermScreen() { vterm_free(vterm_); }
  VtermScreen(const VtermScreen&) = delete;
  VtermScreen& operator=(const VtermScreen&) = delete;

  void resize(int columns, int rows) {
    columns_ = columns;
    rows_ = rows;
    vterm_set_size(vterm_, rows, columns);
  }
  void write(const std::string& bytes) { vterm_input_write(vterm_, bytes.data(), bytes.size()); }

  [[nodiscard]] ShownCell at(int column, int row) const {
    VTermScreenCell cell;
    vterm_screen_get_cell(screen_, {row, column}, &cell);
    ShownCell shown;
    if (cell.chars[0] != 0) shown.character = cell.chars[0];
    shown.bold = cell.attrs.bold != 0;
    shown.reverse = cell.attrs.reverse != 0;
    if (!VTERM_COLOR_IS_DEFAULT_FG(&cell.fg)) shown.fore = color(cell.fg);
    if (!VTERM_COLOR_IS_DEFAULT_BG(&cell.bg)) shown.back = color(cell.bg);
    return shown;
  }
  /// All rows, each with a line feed and without the spaces at its end.
  [[nodiscard]] std::string text() const {
    std::string all;
    for (int row = 0; row < rows_; ++row) {
      std::string line = row_of(screen_, row, columns_);
      line.erase(line.find_last_not_of(' ') + 1);
      all += line + '\n';
    }
    return all;
  }

 private:
  static std::uint32_t color(const VTermColor& color) {
    if (VTERM_COLOR_IS_INDEXED(&color)) return color.indexed.idx;
    return (std::uint32_t{color.rgb.red} << 16U) | (std::uint32_t{color.rgb.green} << 8U) |
           color.rgb.blue;
  }

  int columns_;
  int rows_;
  VTerm* vterm_;
  VTermScreen* screen_ = nullptr;
};

}  // namespace carom::support
