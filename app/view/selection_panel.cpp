#include "view/selection_panel.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "view/panel.hpp"
#include "view/user_interface.hpp"

namespace carom {
namespace {

struct Button {
  int key;
  std::string word;
};

std::vector<std::vector<Button>> buttons(const SelectedBall& selected) {
  if (selected.ball.fixed) return {{{'X', "X:remove"}, {key::kEscape, "Esc:close"}}};
  return {{{'F', selected.followed ? "F:let go" : "F:follow"}, {'X', "X:remove"}},
          {{'*', "*:heavier"}, {'/', "/:lighter"}},
          {{key::kEscape, "Esc:close"}}};
}

std::vector<std::string> lines_of(const SelectedBall& selected) {
  const Ball& ball = selected.ball;
  std::vector<std::string> lines{fmt::format("mass {:.6g}", ball.mass),
                                 fmt::format("radius {:.6g}", ball.radius)};
  if (ball.fixed) {
    lines.emplace_back("fixed: never moves");
    return lines;
  }
  lines.push_back(fmt::format("speed {:.4g}", ball.velocity.norm()));
  if (selected.spins) lines.push_back(fmt::format("spin {:.4g} rad/s", ball.spin));
  lines.push_back(selected.next);
  if (!selected.worker.empty()) lines.push_back(selected.worker);
  return lines;
}

}  // namespace

Canvas selection_panel(const SelectedBall& selected, int columns, int rows, Glyphs glyphs) {
  std::vector<std::string> lines = lines_of(selected);
  for (const auto& row : buttons(selected)) {
    std::string line;
    for (const Button& button : row) line += (line.empty() ? "" : "  ") + button.word;
    lines.push_back(line);
  }
  // As wide with each number, so that it does not jump.
  constexpr std::size_t kWidth = 26;
  lines.front().resize(std::max(lines.front().size(), kWidth), ' ');
  return framed(text_block(lines, columns - kFrame, rows - kFrame),
                fmt::format("ball {}", selected.number), glyphs);
}

std::optional<int> selection_key_at(const SelectedBall& selected, int columns, int rows, int column,
                                    int row) {
  if (column >= columns - kEdge || row >= rows - kEdge) return std::nullopt;
  const auto all = buttons(selected);
  const int line = row - kEdge - static_cast<int>(lines_of(selected).size());
  if (line < 0 || line >= static_cast<int>(all.size())) return std::nullopt;
  int start = kEdge;
  for (const Button& button : all[static_cast<std::size_t>(line)]) {
    const int end = start + static_cast<int>(button.word.size());
    if (column >= start && column < end) return button.key;
    start = end + 2;
  }
  return std::nullopt;
}

}  // namespace carom
