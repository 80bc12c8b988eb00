#include "view/keys.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace carom {

std::string effect_keys(const Effects& effects) {
  std::string keys;
  for_each_effect([&](const auto& entry) {
    if (effects.*entry.slot) keys += entry.key;
  });
  return keys;
}

std::vector<KeyHint> key_hints(int width, bool paused, std::string_view effects) {
  struct Hint {
    char key;
    std::string text;
    int rank;  ///< those of a low one are shown before those of a higher one
    bool useful = true;
  };
  const std::array hints = std::to_array<Hint>({
      {' ', paused ? "space:go on" : "space:pause", 2},
      {'.', ",.:frame", 3, paused},
      {'a', "a:add", 4},
      {'x', "x:remove", 5},
      {'r', "r:restart", 7},
      {'+', "+-:speed", 8},
      {'b', "b:glyphs", 9},
      {'e', "e:cost", 11},
      {'l', "l:threads", 10},
      {'h', "h:instruments", 12},
      {'\t', "Tab:scenes", 13},
      {0, fmt::format("{}:on/off", effects), 6, !effects.empty()},
      {'?', "?:help", 1},
      {'q', "q:quit", 0},
  });
  std::array<bool, hints.size()> shown{};
  int used = 0;
  for (int rank = 0; rank < static_cast<int>(hints.size()); ++rank) {
    for (std::size_t i = 0; i < hints.size(); ++i) {
      const int size = static_cast<int>(hints[i].text.size()) + 1;
      if (hints[i].rank != rank || !hints[i].useful || used + size > width) continue;
      shown[i] = true;
      used += size;
    }
  }
  std::vector<KeyHint> result;
  int column = 0;
  for (std::size_t i = 0; i < hints.size(); ++i) {
    if (!shown[i]) continue;
    result.push_back({hints[i].key, hints[i].text, column + 1});
    column += 1 + static_cast<int>(hints[i].text.size());
  }
  return result;
}

int key_of_hint(const std::vector<KeyHint>& hints, int column) {
  for (const KeyHint& hint : hints) {
    const int within = column - hint.column;
    if (within < 0 || within >= static_cast<int>(hint.text.size())) continue;
    // Several keys before the colon: the one that was clicked.
    const auto colon = hint.text.find(':', 1);
    const bool several =
        hint.key == 0 || hint.text.starts_with("+-") || hint.text.starts_with(",.");
    if (!several) return hint.key;
    return static_cast<std::size_t>(within) < colon ? hint.text[static_cast<std::size_t>(within)]
                                                    : hint.key;
  }
  return 0;
}

std::string hint_line(const std::vector<KeyHint>& hints) {
  std::string line;
  for (const KeyHint& hint : hints) line += ' ' + hint.text;
  return line;
}

}  // namespace carom
