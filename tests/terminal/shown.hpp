#pragma once

#include <vterm.h>

#include <string>

namespace carom {

/// A terminal without a program: what it shows of bytes that come.
class Shown {
 public:
  Shown(int columns, int rows)
      : columns_(columns), rows_(rows), terminal_(vterm_new(rows, columns)) {
    vterm_set_utf8(terminal_, 1);
    screen_ = vterm_obtain_screen(terminal_);
    vterm_screen_reset(screen_, 1);
  }
  ~Shown() { vterm_free(terminal_); }
  Shown(const Shown&) = delete;
  Shown& operator=(const Shown&) = delete;

  void resize(int columns, int rows) {
    columns_ = columns;
    rows_ = rows;
    vterm_set_size(terminal_, rows, columns);
  }
  void write(const std::string& bytes) { vterm_input_write(terminal_, bytes.data(), bytes.size()); }
  [[nodiscard]] std::string text() const {
    std::string all;
    for (int row = 0; row < rows_; ++row) {
      std::string line;
      for (int column = 0; column < columns_; ++column) {
        VTermScreenCell cell;
        vterm_screen_get_cell(screen_, {row, column}, &cell);
        const auto character = cell.chars[0];
        line += character == 0 ? ' ' : character < 0x80 ? static_cast<char>(character) : '?';
      }
      line.erase(line.find_last_not_of(' ') + 1);
      all += line + '\n';
    }
    return all;
  }

 private:
  int columns_;
  int rows_;
  VTerm* terminal_;
  VTermScreen* screen_ = nullptr;
};

}  // namespace carom
