#include "view/text_screen.hpp"

#include <fmt/format.h>

#include "view/encoder.hpp"

namespace carom {

std::string to_text(const Canvas& canvas, std::uint64_t frame, double time) {
  std::string text = fmt::format("# frame {} time {}\n", frame, time);
  for (int row = 0; row < canvas.rows; ++row) {
    std::string line;
    for (int column = 0; column < canvas.columns; ++column)
      append_utf8(canvas.at(column, row).character, line);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

}  // namespace carom
