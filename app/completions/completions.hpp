#pragma once

#include <string>

#include "option_table.hpp"

namespace carom {

/// Completion scripts for shells, written from the tables of commands and options.
std::string bash_completions();
std::string zsh_completions();
std::string fish_completions();

/// What completes the value of an option.
enum class Completion { nothing, words, files, cases };
Completion completion_of(const OptionRow& row);

/// What completes the words after a command.
enum class Operand { none, scenes, scenes_and_folders, commands };
Operand operand_of(const CommandRow& row);

/// What the option is for, without the colon before a list of words.
std::string purpose_of(const OptionRow& row);

bool takes(const CommandRow& command, const OptionRow& row);

/// A POSIX shell's pipe that prints the first word of each entry, as of `carom scenes`.
inline constexpr const char* kFirstWords = "2>/dev/null | sed -n 's/^\\([^ ][^ ]*\\) .*/\\1/p'";

}  // namespace carom
