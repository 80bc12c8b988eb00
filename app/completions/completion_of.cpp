#include <algorithm>

#include "completions/completions.hpp"

namespace carom {

Completion completion_of(const OptionRow& row) {
  if (!row.rule.words.empty()) return Completion::words;
  if (row.value == "FILE") return Completion::files;
  return row.name == "--case" ? Completion::cases : Completion::nothing;
}

Operand operand_of(const CommandRow& row) {
  if (row.most_arguments == 0) return Operand::none;
  if (row.command == Options::Command::help) return Operand::commands;
  return row.command == Options::Command::sweep ? Operand::scenes_and_folders : Operand::scenes;
}

std::string purpose_of(const OptionRow& row) {
  return row.purpose.ends_with(':') ? row.purpose.substr(0, row.purpose.size() - 1) : row.purpose;
}

bool takes(const CommandRow& command, const OptionRow& row) {
  return std::find(row.commands.begin(), row.commands.end(), command.command) != row.commands.end();
}

}  // namespace carom
