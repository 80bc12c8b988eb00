#include "help.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <sstream>

namespace carom {
namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kMeaningAt = 25;

}  // namespace

std::string help_row(const std::string& what, const std::string& meaning) {
  std::string text;
  std::string line = fmt::format("  {:<{}}", what, kMeaningAt - 3);
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

std::string help_options(const CLI::App& app) {
  std::string text;
  for (const std::string& group : app.get_groups()) {
    const auto options = app.get_options([&](const CLI::Option* option) {
      return option->get_group() == group && !option->get_positional();
    });
    if (options.empty()) continue;
    text += fmt::format("\n{}:\n", group);
    for (const CLI::Option* const option : options) {
      const auto& shorts = option->get_snames();
      const std::string lead = shorts.empty() ? "    " : '-' + shorts.front() + ", ";
      const bool flag = option->get_items_expected_max() == 0;
      text += help_row(
          lead + "--" + option->get_lnames().front() + (flag ? "" : ' ' + option->get_type_name()),
          option->get_description());
    }
  }
  return text;
}

}  // namespace carom
