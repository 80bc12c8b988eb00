#include "view/wrap.hpp"

#include <algorithm>

namespace carom {

std::vector<std::string> wrapped(std::string_view words, int width) {
  std::vector<std::string> lines;
  const auto room = static_cast<std::size_t>(std::max(1, width));
  while (!words.empty()) {
    if (words.size() <= room) {
      lines.emplace_back(words);
      break;
    }
    const auto blank = words.rfind(' ', room);
    const bool cut = blank == std::string_view::npos || blank == 0;
    lines.emplace_back(words.substr(0, cut ? room : blank));
    words.remove_prefix(cut ? room : blank + 1);
  }
  return lines;
}

}  // namespace carom
