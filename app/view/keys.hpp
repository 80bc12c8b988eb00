#pragma once

#include <array>
#include <string>
#include <string_view>

#include "carom/effects.hpp"
#include "view/canvas.hpp"

namespace carom {

/// A key and what it does, as the help tells it.
struct KeyHelp {
  std::string_view keys;
  std::string_view help;
};

inline constexpr std::array<KeyHelp, 20> kKeyHelp{{
    {"space p", "pause, and go on"},
    {".", "one frame while paused"},
    {"a", "add a ball at a free place"},
    {"A", "add ten balls"},
    {"x", "remove the newest ball"},
    {"r", "start again from the beginning"},
    {"+", "twice the speed"},
    {"-", "half the speed"},
    {"[ ]", "halve, double the time step"},
    {"w", "walls off and on, where the scene has them"},
    {"c", "collisions off and on"},
    {"g", "gravity off and on"},
    {"d", "drag off and on"},
    {"f", "friction off and on"},
    {"t", "attraction off and on"},
    {"m", "the other method, overlap or event"},
    {"e", "what this run costs, and how wrong it is"},
    {"E", "beside it an exact run: its balls as '+'"},
    {"?", "this list, its next page, and away"},
    {"q", "quit"},
}};

/// Whether the help has a line for the key of every effect.
constexpr bool tells_every_effect() {
  bool all = true;
  for_each_effect([&all](const auto& entry) {
    bool told = false;
    for (const KeyHelp& line : kKeyHelp) {
      told |= line.keys.size() == 1 && line.keys[0] == entry.key &&
              line.help.substr(0, entry.name.size()) == entry.name;
    }
    all &= told;
  });
  return all;
}
static_assert(tells_every_effect());

/// The keys of the effects that are named, in the order of the table.
std::string effect_keys(const Effects& effects);

/// The keys that do something now, each with a word, as many as fit into `width` characters; the
/// way to the help and out stays longest.  `effects` are the keys of the effects there are.
std::string key_hints(int width, bool paused, std::string_view effects);

/// The pages that the help takes on a canvas of this size.
int help_pages(const Canvas& canvas);

/// Lays page `page` (from 0) of the help over the canvas, framed where there is room.
void paint_help(Canvas& canvas, int page);

}  // namespace carom
