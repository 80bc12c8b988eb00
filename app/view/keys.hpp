#pragma once

#include <array>
#include <string>
#include <string_view>

#include "view/canvas.hpp"

namespace carom {

/// A key and what it does, as the help tells it.
struct KeyHelp {
  std::string_view keys;
  std::string_view help;
};

inline constexpr std::array<KeyHelp, 15> kKeyHelp{{
    {"space p", "pause, and go on"},
    {".", "one frame while paused"},
    {"a", "add a ball at a free place"},
    {"A", "add ten balls"},
    {"x", "remove the newest ball"},
    {"r", "start again from the beginning"},
    {"+", "twice the speed"},
    {"-", "half the speed"},
    {"[ ]", "halve, double the time step"},
    {"g", "gravity on and off, where the scene has it"},
    {"m", "the other method, overlap or event"},
    {"e", "what this run costs, and how wrong it is"},
    {"E", "beside it an exact run: its balls as '+'"},
    {"?", "this list, its next page, and away"},
    {"q", "quit"},
}};

/// The keys that do something now, each with a word, as many as fit into `width` characters; the
/// way to the help and out stays longest.
std::string key_hints(int width, bool paused, bool gravity);

/// The pages that the help takes on a canvas of this size.
int help_pages(const Canvas& canvas);

/// Lays page `page` (from 0) of the help over the canvas, framed where there is room.
void paint_help(Canvas& canvas, int page);

}  // namespace carom
