#include "view/keys.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

constexpr int kFrame = 2;  // rows or columns that a frame around the help takes

int lines_per_page(const Canvas& canvas) {
  const int all = static_cast<int>(kKeyHelp.size());
  if (canvas.rows >= all + kFrame) return all;
  return std::max(1, canvas.rows - kFrame);
}

}  // namespace

std::string effect_keys(const Effects& effects) {
  std::string keys;
  for_each_effect([&](const auto& entry) {
    if (effects.*entry.slot) keys += entry.key;
  });
  return keys;
}

std::string key_hints(int width, bool paused, std::string_view effects) {
  struct Hint {
    std::string text;
    bool useful = true;
  };
  const std::array<Hint, 10> hints{{{" space:pause"},
                                    {" .:frame", paused},
                                    {" aA:add"},
                                    {" x:remove"},
                                    {" r:restart"},
                                    {" +-:speed"},
                                    {" []:step"},
                                    {fmt::format(" {}:on/off", effects), !effects.empty()},
                                    {" ?:help"},
                                    {" q:quit"}}};
  constexpr std::array<std::size_t, 10> kByNeed{9, 8, 0, 1, 2, 5, 4, 7, 3, 6};
  std::array<bool, 10> shown{};
  std::size_t used = 0;
  for (const std::size_t i : kByNeed) {
    if (!hints[i].useful) continue;
    if (used + hints[i].text.size() > static_cast<std::size_t>(std::max(0, width))) break;
    used += hints[i].text.size();
    shown[i] = true;
  }
  std::string line;
  for (std::size_t i = 0; i < hints.size(); ++i) {
    if (shown[i]) line += hints[i].text;
  }
  return line;
}

int help_pages(const Canvas& canvas) {
  const int lines = lines_per_page(canvas);
  return (static_cast<int>(kKeyHelp.size()) + lines - 1) / lines;
}

void paint_help(Canvas& canvas, int page) {
  const int lines = lines_per_page(canvas);
  std::vector<std::string> text;
  std::size_t widest = 0;
  for (int i = page * lines; i < std::min((page + 1) * lines, static_cast<int>(kKeyHelp.size()));
       ++i) {
    const KeyHelp& key = kKeyHelp[static_cast<std::size_t>(i)];
    text.push_back(fmt::format(" {:<8} {} ", key.keys, key.help));
    widest = std::max(widest, text.back().size());
  }
  const int width = std::min(static_cast<int>(widest), canvas.columns - kFrame);
  if (width < 1) return;
  const int left = (canvas.columns - width) / 2;
  int row = std::max(0, (canvas.rows - static_cast<int>(text.size()) - kFrame) / 2);
  const std::string edge = '+' + std::string(static_cast<std::size_t>(width), '-') + '+';
  canvas.write(left - 1, row++, edge, Ink::notice);
  for (const std::string& line : text) {
    canvas.write(left - 1, row++,
                 fmt::format("|{:<{}}|", line.substr(0, static_cast<std::size_t>(width)), width),
                 Ink::notice);
  }
  canvas.write(left - 1, row, edge, Ink::notice);
}

}  // namespace carom
