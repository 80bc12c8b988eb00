#include "view/panel.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace carom {

Canvas framed(const Canvas& inside, const std::string& title, Glyphs glyphs) {
  const bool ascii = glyphs == Glyphs::ascii;
  Canvas panel(inside.columns + kFrame, inside.rows + kFrame);
  const int right = panel.columns - 1;
  const int bottom = panel.rows - 1;
  for (int column = 1; column < right; ++column) {
    for (const int row : {0, bottom}) panel.put(column, row, ascii ? U'-' : U'─', Ink::notice);
  }
  for (int row = 1; row < bottom; ++row) {
    for (const int column : {0, right}) panel.put(column, row, ascii ? U'|' : U'│', Ink::notice);
  }
  panel.put(0, 0, ascii ? U'+' : U'┌', Ink::notice);
  panel.put(right, 0, ascii ? U'+' : U'┐', Ink::notice);
  panel.put(0, bottom, ascii ? U'+' : U'└', Ink::notice);
  panel.put(right, bottom, ascii ? U'+' : U'┘', Ink::notice);
  if (!title.empty() && inside.columns >= 4) {
    const auto room = static_cast<std::size_t>(inside.columns - 3);
    panel.write(2, 0, ' ' + title.substr(0, room) + ' ', Ink::notice);
  }
  lay_over(inside, 1, 1, panel);
  return panel;
}

Canvas text_block(const std::vector<std::string>& lines, int columns, int rows) {
  std::size_t widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, line.size());
  Canvas block(std::min(static_cast<int>(widest), columns),
               std::min(static_cast<int>(lines.size()), rows));
  for (int row = 0; row < block.rows; ++row)
    block.write(0, row, lines[static_cast<std::size_t>(row)], Ink::status);
  return block;
}

std::string exponent(double value) {
  return value == 0 ? "0" : fmt::format("{:.1e}", value);
}

void lay_over(const Canvas& above, int column, int row, Canvas& canvas) {
  for (int i = 0; i < above.rows; ++i) {
    for (int j = 0; j < above.columns; ++j) {
      if (canvas.holds(column + j, row + i)) canvas.at(column + j, row + i) = above.at(j, i);
    }
  }
}

}  // namespace carom
