#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "carom/scene.hpp"

namespace carom::scene {

/// The lines of a script as their file has them: an object for each word of a command.

/// The command of a line; the line's type says which.
struct CommandWord {};

struct AddLine {
  static constexpr std::string_view kWord = "add";
  double at = 0;
  CommandWord command{};
  Ball ball{};
};
struct RemoveLine {
  static constexpr std::string_view kWord = "remove";
  double at = 0;
  CommandWord command{};
  std::optional<std::size_t> ball{};
};
struct PauseLine {
  static constexpr std::string_view kWord = "pause";
  double at = 0;
  CommandWord command{};
};
struct ResumeLine {
  static constexpr std::string_view kWord = "resume";
  double at = 0;
  CommandWord command{};
};
/// What a line sets of the solver.
struct NewStep {
  std::optional<double> step;
};
struct SetLine {
  static constexpr std::string_view kWord = "set";
  double at = 0;
  CommandWord command{};
  std::optional<Effects> effects{};
  std::optional<NewStep> solver{};
};
struct QuitLine {
  static constexpr std::string_view kWord = "quit";
  double at = 0;
  CommandWord command{};
};
/// A line whose command is not known.
struct AnyLine {
  double at = 0;
  CommandWord command{};
};

/// Calls `visit` with a line of each command.
template <class Visit>
void for_each_line(Visit&& visit) {
  visit(AddLine{});
  visit(RemoveLine{});
  visit(PauseLine{});
  visit(ResumeLine{});
  visit(SetLine{});
  visit(QuitLine{});
}

}  // namespace carom::scene
