#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace carom::shown {

/// A command that a page shows, with the output that it shows.
struct Command {
  std::size_t line = 0;  ///< of the page
  std::string text;      ///< without the prompt
  bool with_output = false;
  std::vector<std::string> output;
  std::string mark;  ///< what its block is marked with after "console"; may be empty
};

/// The commands of a page: of a Markdown page those after "$ " in blocks marked console; of a
/// manual page those of literal blocks after "$ ", and the lines there that begin with the
/// program's name, whose output is not shown.
std::vector<Command> commands_in(const std::filesystem::path& page);

/// A line without what a machine or a moment decides: numbers, units of time, spaces and the marks
/// of the Pareto front.
std::string masked(const std::string& line);

/// Whether the lines are those shown; a shown line "..." stands for any lines.
bool matches(const std::vector<std::string>& shown, const std::vector<std::string>& found);

std::vector<std::string> lines_of(const std::string& text);

}  // namespace carom::shown
