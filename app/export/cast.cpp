#include "export/cast.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "export/json_text.hpp"

namespace carom {
namespace {

using Row = std::vector<std::string>;

/// The characters of UTF-8 text, row by row.
std::vector<Row> cells_of(const std::string& picture) {
  std::vector<Row> rows;
  Row row;
  for (const char c : picture) {
    if (c == '\n') {
      rows.push_back(std::move(row));
      row.clear();
    } else if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U && !row.empty()) {
      row.back() += c;
    } else {
      row.emplace_back(1, c);
    }
  }
  return rows;
}

std::string changes_of_row(Row before, Row after, std::size_t number) {
  constexpr std::size_t kGap = 6;  // as many cells are written again sooner than skipped
  const std::size_t width = std::max(before.size(), after.size());
  before.resize(width, " ");
  after.resize(width, " ");
  std::string text;
  for (std::size_t k = 0; k < width;) {
    if (before[k] == after[k]) {
      ++k;
      continue;
    }
    std::size_t end = k + 1;  // behind the last changed cell
    for (std::size_t m = end; m < width && m < end + kGap; ++m) {
      if (before[m] != after[m]) end = m + 1;
    }
    text += fmt::format("\x1b[{};{}H", number + 1, k + 1);
    for (; k < end; ++k) text += after[k];
  }
  return text;
}

}  // namespace

CastText::CastText(int columns, int rows, const std::string& title)
    : header_(fmt::format("{{\"version\": 2, \"width\": {}, \"height\": {}, \"title\": {}, "
                          "\"env\": {{\"TERM\": \"xterm-256color\"}}}}\n",
                          columns, rows, json_text(title))) {}

std::string CastText::output(double seconds, std::string_view bytes) {
  if (bytes.empty()) return {};
  return fmt::format("[{:.6f}, \"o\", {}]\n", seconds, json_text(bytes));
}

std::string CastText::resize(double seconds, int columns, int rows) {
  return fmt::format("[{:.6f}, \"r\", \"{}x{}\"]\n", seconds, columns, rows);
}

std::string PictureChanges::next(const std::string& picture) {
  std::vector<Row> rows = cells_of(picture);
  // Hides the cursor and clears the screen.
  std::string text = shown_.empty() ? "\x1b[?25l\x1b[2J" : "";
  shown_.resize(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) text += changes_of_row(shown_[k], rows[k], k);
  shown_ = std::move(rows);
  return text;
}

std::string PictureChanges::end() {
  return "\x1b[?25h";
}

}  // namespace carom
