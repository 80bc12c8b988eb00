#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completions/completions.hpp"

namespace carom {
namespace {

std::string in_single_quotes(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + '\'';
}

/// As in "__carom_command run": true on a line of that command.
std::string condition(const CommandRow& command) {
  return in_single_quotes("__carom_command " + command.name);
}

std::string value_of(const OptionRow& row) {
  switch (completion_of(row)) {
    case Completion::words:
      return fmt::format(" -x -a '{}'", fmt::join(row.rule.words, " "));
    case Completion::files:
      return " -r -F";
    case Completion::cases:
      return " -x -a '(__carom_first_words verify --list)'";
    case Completion::nothing:
      break;
  }
  return row.value.empty() ? "" : " -x";
}

std::string operand_line(const CommandRow& command, const std::string& commands) {
  const std::string start = "complete -c carom -n " + condition(command);
  switch (operand_of(command)) {
    case Operand::scenes:
    case Operand::scenes_and_folders:
      return start + " -F -a '(__carom_first_words scenes)'\n";
    case Operand::commands:
      return start + fmt::format(" -a '{}'\n", commands);
    case Operand::none:
      break;
  }
  return "";
}

constexpr const char* kFishStart = R"sh(# Completions of carom for fish.
function __carom_first_words
  set -l words (commandline -opc)
  $words[1] $argv 2>/dev/null | string match -r '^\S+'
end
function __carom_command
  set -l words (commandline -opc)
  set -l command play
  if set -q words[2]; and contains -- $words[2] {0}
    set command $words[2]
  end
  test $command = $argv[1]
end
complete -c carom -f
complete -c carom -s h -l help -d 'print this help'
complete -c carom -l version -d 'print the version'
)sh";

}  // namespace

std::string fish_completions() {
  std::vector<std::string> names;
  for (const CommandRow& command : command_table()) names.push_back(command.name);
  const std::string commands = fmt::format("{}", fmt::join(names, " "));
  std::string text = fmt::format(kFishStart, commands);
  for (const CommandRow& command : command_table()) {
    text +=
        fmt::format("complete -c carom -n 'test (count (commandline -opc)) -eq 1' -a {} -d {}\n",
                    command.name, in_single_quotes(command.purpose));
  }
  for (const CommandRow& command : command_table()) {
    text += operand_line(command, commands);
    for (const OptionRow& row : option_table()) {
      if (!takes(command, row)) continue;
      text += fmt::format("complete -c carom -n {} -l {}{} -d {}\n", condition(command),
                          row.name.substr(2), value_of(row), in_single_quotes(purpose_of(row)));
    }
  }
  return text;
}

}  // namespace carom
