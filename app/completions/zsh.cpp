#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completions/completions.hpp"

namespace carom {
namespace {

/// A text within an argument in single quotes of _arguments: each of `marked` with a backslash.
std::string escaped(const std::string& text, const std::string& marked) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\'";
    } else if (marked.find(c) != std::string::npos) {
      result += '\\';
    }
    result += c;
  }
  return result;
}

std::string action(const OptionRow& row) {
  switch (completion_of(row)) {
    case Completion::words:
      return fmt::format("({})", fmt::join(row.rule.words, " "));
    case Completion::files:
      return "_files";
    case Completion::cases:
      return "_carom_cases";
    case Completion::nothing:
      break;
  }
  return " ";
}

std::string option_line(const OptionRow& row) {
  const std::string purpose = escaped(purpose_of(row), "[]:");
  const std::string repeats = row.rule.repeats ? "*" : "";
  if (row.value.empty()) return fmt::format("        '{}{}[{}]'\n", repeats, row.name, purpose);
  return fmt::format("        '{}{}=[{}]:{}:{}'\n", repeats, row.name, purpose,
                     escaped(row.value, ":"), action(row));
}

std::string operand_line(const CommandRow& command) {
  switch (operand_of(command)) {
    case Operand::scenes:
      return "        '*:scene:_carom_scenes'\n";
    case Operand::scenes_and_folders:
      return "        '1:scene:_carom_scenes' '2:folder:_files -/'\n";
    case Operand::commands:
      return "        '1:command:_carom_commands'\n";
    case Operand::none:
      break;
  }
  return "";
}

constexpr const char* kZshStart = R"sh(#compdef carom
# Completions of carom for zsh.
_carom_commands() {{
  local -a rows=(
{0}  )
  _describe command rows
}}
_carom_scenes() {{
  local -a names=(${{(f)"$($carom scenes {1})"}})
  compadd -a names
  _files
}}
_carom_cases() {{
  local -a names=(${{(f)"$($carom verify --list {1})"}})
  compadd -a names
}}
_carom() {{
  local carom=$words[1] command=play
  local -a options
  if (( CURRENT > 2 )) && [[ $words[2] == ({2}) ]]; then
    command=$words[2]
    shift words
    (( CURRENT-- ))
  elif (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then
    _carom_commands
  fi
  case $command in
)sh";

}  // namespace

std::string zsh_completions() {
  std::vector<std::string> names;
  std::string commands;
  for (const CommandRow& command : command_table()) {
    names.push_back(command.name);
    commands += fmt::format("    '{}:{}'\n", command.name, escaped(command.purpose, ":"));
  }
  std::string text = fmt::format(kZshStart, commands, kFirstWords, fmt::join(names, "|"));
  for (const CommandRow& command : command_table()) {
    text += fmt::format("    {})\n      options=(\n", command.name);
    for (const OptionRow& row : option_table()) {
      if (takes(command, row)) text += option_line(row);
    }
    text += operand_line(command);
    text += "      )\n      ;;\n";
  }
  return text +
         "  esac\n"
         "  _arguments $options '(- *)'{-h,--help}'[print this help]' \\\n"
         "    '(- *)--version[print the version]'\n"
         "}\n"
         "_carom \"$@\"\n";
}

}  // namespace carom
