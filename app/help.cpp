#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <sstream>

#include "help.hpp"

namespace carom {
namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kMeaningAt = 25;

/// What to write, then what it means.
std::string help_row(const std::string& what, const std::string& meaning) {
  std::string text;
  std::string line = fmt::format("  {:<{}}", what, kMeaningAt - 3);
  if (line.size() >= kMeaningAt) {
    text = line + '\n';
    line = std::string(kMeaningAt - 1, ' ');
  }
  std::istringstream words(meaning);
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() >= kWidth) {
      text += line + '\n';
      line = std::string(kMeaningAt - 1, ' ');
    }
    line += ' ' + word;
  }
  return text + line + '\n';
}

}  // namespace

std::string HelpText::make_description(const CLI::App* app) const {
  const std::string of = app->get_parent() == nullptr ? "" : "carom " + app->get_name() + ": ";
  return of + app->get_description() + '\n';
}

std::string HelpText::make_usage(const CLI::App* app, std::string name) const {
  std::string usage = "\nUsage: " + name;
  for (const CLI::Option* option : app->get_options(&CLI::Option::get_positional)) {
    usage += ' ' + option->get_type_name();
  }
  usage += " [OPTION...]\n";
  if (app->get_parent() == nullptr) usage += "       " + name + " COMMAND ...\n";
  return usage + '\n';
}

std::string HelpText::make_group(std::string group, bool is_positional,
                                 std::vector<const CLI::Option*> options) const {
  if (is_positional) group = "Arguments";
  std::string text = group + ":\n";
  for (const CLI::Option* option : options) text += make_option(option, is_positional);
  return is_positional ? text + '\n' : text;
}

std::string HelpText::make_option(const CLI::Option* option, bool is_positional) const {
  if (is_positional) return help_row(option->get_name(), option->get_description());
  const auto& shorts = option->get_snames();
  const std::string lead = shorts.empty() ? "    " : '-' + shorts.front() + ", ";
  const bool flag = option->get_items_expected_max() == 0;
  return help_row(
      lead + "--" + option->get_lnames().front() + (flag ? "" : ' ' + option->get_type_name()),
      option->get_description());
}

std::string HelpText::make_subcommand(const CLI::App* command) const {
  std::string what = command->get_name();
  for (const CLI::Option* option : command->get_options(&CLI::Option::get_positional)) {
    what += ' ' + option->get_type_name();
  }
  return help_row(what, command->get_description());
}

}  // namespace carom
