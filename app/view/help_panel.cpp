#include "view/help_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "view/keys.hpp"
#include "view/panel.hpp"

namespace carom {
namespace {

constexpr int kColumn = 39;
constexpr int kNarrow = 2 * kColumn + kFrame;

struct HelpLine {
  std::string text;
  Ink ink = Ink::status;
};
using Column = std::vector<HelpLine>;

/// Every line of the help, a heading before each group.
std::vector<Column> groups() {
  std::vector<Column> groups;
  std::string_view group;
  for (const KeyHelp& key : kKeyHelp) {
    if (key.group != group) {
      group = key.group;
      groups.emplace_back();
      groups.back().push_back({' ' + std::string(group), Ink::notice});
    }
    groups.back().push_back({fmt::format("  {:<8} {}", key.keys, key.help), Ink::status});
  }
  return groups;
}

/// The lines in columns: two of them, cut between two groups so that they are about as long.
std::vector<Column> columns(bool two) {
  std::vector<Column> result(1);
  std::size_t all = 0;
  const std::vector<Column> parts = groups();
  for (const Column& part : parts) all += part.size();
  for (const Column& part : parts) {
    if (two && result.size() == 1 && 2 * result[0].size() + part.size() > all + 1)
      result.emplace_back();
    result.back().insert(result.back().end(), part.begin(), part.end());
  }
  return result;
}

int rows_of(const std::vector<Column>& columns) {
  std::size_t most = 0;
  for (const Column& column : columns) most = std::max(most, column.size());
  return static_cast<int>(most);
}

int rows_per_page(const Canvas& canvas) {
  return std::max(1, canvas.rows - kFrame);
}

std::vector<Column> columns_for(const Canvas& canvas) {
  return columns(canvas.columns >= kNarrow);
}

}  // namespace

int help_pages(const Canvas& canvas) {
  const int page = rows_per_page(canvas);
  return (rows_of(columns_for(canvas)) + page - 1) / page;
}

void paint_help(Canvas& canvas, int page, Glyphs glyphs) {
  const std::vector<Column> all = columns_for(canvas);
  const int first = page * rows_per_page(canvas);
  const int rows = std::min(rows_of(all) - first, rows_per_page(canvas));
  const int width = std::min(canvas.columns - kFrame, static_cast<int>(all.size()) * kColumn);
  if (rows < 1 || width < 1) return;
  Canvas text(width, rows);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (int row = 0; row < rows; ++row) {
      const auto line = static_cast<std::size_t>(first + row);
      if (line < all[i].size())
        text.write(static_cast<int>(i * kColumn), row, all[i][line].text, all[i][line].ink);
    }
  }
  const int pages = help_pages(canvas);
  const Canvas panel = framed(
      text, pages > 1 ? fmt::format("help, page {} of {}", page + 1, pages) : "help", glyphs);
  lay_over(panel, (canvas.columns - panel.columns) / 2, (canvas.rows - panel.rows) / 2, canvas);
}

}  // namespace carom
