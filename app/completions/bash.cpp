#include <fmt/format.h>
#include <fmt/ranges.h>

#include "completions/completions.hpp"

namespace carom {
namespace {

constexpr const char* kBashStart = R"sh(# Completions of carom for bash.
_carom() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  local command=${{COMP_WORDS[1]}} words='' kinds=''
  COMPREPLY=()
  # bash splits --option=value into three words.
  if [[ $current == = ]]; then
    current=''
  elif [[ $previous == = ]]; then
    previous=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  case $command in
    {0}) [[ $COMP_CWORD -gt 1 ]] || command='' ;;
    *) command='' ;;
  esac
  case ${{command:-play}} in
)sh";

constexpr const char* kBashEnd = R"sh(  esac
  if [[ -z $command && $kinds == scenes && $COMP_CWORD -eq 1 ]]; then words+='{0}'; fi
  if [[ $kinds == scenes ]]; then words+=" $("${{COMP_WORDS[0]}}" scenes {1})"; fi
  if [[ $kinds == cases ]]; then words+=" $("${{COMP_WORDS[0]}}" verify --list {1})"; fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  if [[ $kinds == scenes || $kinds == files ]]; then
    compopt -o filenames 2>/dev/null
    local file
    while IFS= read -r file; do COMPREPLY+=("$file"); done < <(compgen -f -- "$current")
  fi
}}
complete -F _carom carom
)sh";

/// What stands in `words` or `kinds` where the value of an option is written.
std::string value_case(const OptionRow& row) {
  switch (completion_of(row)) {
    case Completion::words:
      return fmt::format("words='{}'", fmt::join(row.rule.words, " "));
    case Completion::files:
      return "kinds=files";
    case Completion::cases:
      return "kinds=cases";
    case Completion::nothing:
      break;
  }
  return ":";
}

std::string operand_case(const CommandRow& command, const std::string& commands) {
  switch (operand_of(command)) {
    case Operand::scenes:
    case Operand::scenes_and_folders:
      return "kinds=scenes";
    case Operand::commands:
      return fmt::format("words='{}'", commands);
    case Operand::none:
      break;
  }
  return ":";
}

}  // namespace

std::string bash_completions() {
  std::vector<std::string> names;
  for (const CommandRow& command : command_table()) names.push_back(command.name);
  const std::string commands = fmt::format("{}", fmt::join(names, " "));
  std::string text = fmt::format(kBashStart, fmt::join(names, " | "));
  for (const CommandRow& command : command_table()) {
    text += fmt::format("    {})\n      case $previous in\n", command.name);
    std::string options;
    for (const OptionRow& row : option_table()) {
      if (!takes(command, row)) continue;
      options += row.name + ' ';
      if (!row.value.empty()) {
        text += fmt::format("        {}) {} ;;\n", row.name, value_case(row));
      }
    }
    text += fmt::format(
        "        *)\n"
        "          if [[ $current == -* ]]; then\n"
        "            words='{}-h --help --version'\n"
        "          else\n"
        "            {}\n"
        "          fi\n"
        "          ;;\n"
        "      esac\n"
        "      ;;\n",
        options, operand_case(command, commands));
  }
  return text + fmt::format(kBashEnd, commands, kFirstWords);
}

}  // namespace carom
