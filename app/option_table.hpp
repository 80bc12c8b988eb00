#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "options.hpp"

namespace carom {

/// What an option does with its value.
struct Rule {
  bool Options::*flag = nullptr;   ///< an option without a value sets this
  std::vector<std::string> words;  ///< the only values there are; empty: any that passes `demand`
  bool repeats = false;            ///< given several times, each value counts; else the last one

  /// What the value must be, as in "must be a whole number from 1"; empty where it is right.
  std::function<std::string(const std::string& value)> demand;
  std::function<void(Options& options, const std::string& value)> take;
};

/// An option of the command line.
///
/// A new option is a member of Options, one row of the table in option_table.cpp, and its entry in
/// man/carom.1.  Parsing, messages, --help and the tests follow from the row.
struct OptionRow {
  std::vector<Options::Command> commands;  ///< the commands that take it
  std::string name;                        ///< as in "--time"
  std::string value;                       ///< as in "SECONDS"; empty for a flag
  std::string purpose;                     ///< one line of help
  Rule rule;
};

/// A command of the program.
struct CommandRow {
  Options::Command command;
  std::string name;
  std::string argument;  ///< of its usage, as in "[SCENE]"; empty: it takes none
  std::string argument_purpose;
  std::size_t fewest_arguments;
  std::size_t most_arguments;
  std::string purpose;
  std::string note;  ///< below the help; may be empty
};

std::span<const CommandRow> command_table();
std::span<const OptionRow> option_table();

}  // namespace carom
