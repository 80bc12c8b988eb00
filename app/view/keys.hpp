#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "carom/effects.hpp"

namespace carom {

/// A key and what it does, as the help tells it.
struct KeyHelp {
  std::string_view group;
  std::string_view keys;
  std::string_view help;
};

inline constexpr std::array kKeyHelp = std::to_array<KeyHelp>({
    {"Time", "space p", "pause, and go on"},
    {"Time", ".", "one frame while paused"},
    {"Time", ",", "back by one frame"},
    {"Time", "Bksp", "back by ten frames"},
    {"Time", "+ -", "twice, half the speed"},
    {"Time", "r", "restart"},
    {"Balls", "a", "add a ball at a free place"},
    {"Balls", "A", "add ten balls"},
    {"Balls", "x", "remove the newest ball"},
    {"Balls", "click", "add a ball, or select one"},
    {"Balls", "drag", "throw a new ball"},
    {"Selected", "n", "select the next ball"},
    {"Selected", "F", "follow it, let it go"},
    {"Selected", "X", "remove it"},
    {"Selected", "* /", "twice, half its mass"},
    {"Selected", "Esc", "select none"},
    {"Effects", "w", "walls off and on"},
    {"Effects", "c", "collisions off and on"},
    {"Effects", "g", "gravity off and on"},
    {"Effects", "d", "drag off and on"},
    {"Effects", "f", "friction off and on"},
    {"Effects", "t", "attraction off and on"},
    {"View", "b", "next kind of glyphs"},
    {"View", "< >", "zoom out, zoom in"},
    {"View", "z", "trails of the last frames"},
    {"View", "v", "arrows: velocities"},
    {"View", "N", "numbers on large balls"},
    {"View", "wheel", "zoom at the pointer"},
    {"View", "arrows", "move the view"},
    {"View", "0", "the whole box"},
    {"Computing", "[ ]", "halve, double the time step"},
    {"Computing", "m", "the other method"},
    {"Panels", "e", "cost and accuracy"},
    {"Panels", "E", "exact run beside it: '+'"},
    {"Panels", "h", "instruments: speeds, means"},
    {"Panels", "l", "what each thread does"},
    {"Panels", "L", "slow motion: . next barrier"},
    {"Scenes", "Tab", "choose another scene"},
    {"Scenes", "s", "save the present state"},
    {"Scenes", "o", "record, end the recording"},
    {"Program", "?", "help, its next page"},
    {"Program", "Esc", "close the help"},
    {"Program", "q", "quit"},
});

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

/// A key of the line of hints.
struct KeyHint {
  char key;  ///< what a click on it presses
  std::string text;
  int column = 0;
};

/// The keys that do something now, each with a word, as many as fit into `width` characters; the
/// way to the help and out stays longest.  `effects` are the keys of the effects there are.
std::vector<KeyHint> key_hints(int width, bool paused, std::string_view effects);
/// The key that a click on this column of the line of hints presses; 0: none.
int key_of_hint(const std::vector<KeyHint>& hints, int column);
/// The hints as they stand in their line.
std::string hint_line(const std::vector<KeyHint>& hints);

}  // namespace carom
