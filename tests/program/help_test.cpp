// The parser, the help and the manual page say the same: all are held against the tables.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "option_table.hpp"
#include "options.hpp"
#include "support/process.hpp"

namespace carom::help_test {
namespace {

std::string help(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{CAROM_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const auto outcome = support::run(words);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

/// The entry of an option in a text where each begins with one of `starts`: up to the next one.
std::string entry(const std::string& text, const std::string& start, const std::string& next) {
  const std::size_t begin = text.find(start);
  if (begin == std::string::npos) return "";
  const auto from = static_cast<std::ptrdiff_t>(begin + start.size());
  std::smatch found;
  const std::string rest(text.begin() + from, text.end());
  const bool more = std::regex_search(rest, found, std::regex(next));
  return start + (more ? rest.substr(0, static_cast<std::size_t>(found.position())) : rest);
}

/// A section of the manual page, or nothing.
std::string section(const std::string& title) {
  return entry(support::read_file(CAROM_SOURCE_DIR "/man/carom.1"), "\n.Ss " + title + "\n",
               "\n\\.S[sh] ");
}

std::string page_of_play() {
  return support::read_file(CAROM_SOURCE_DIR "/man/carom-play.1");
}

std::string page_entry(const std::string& command, const OptionRow& row) {
  const std::string start =
      "\n.It Fl " + row.name.substr(1) + (row.value.empty() ? "" : " Ar " + row.value) + "\n";
  // The terminal's has a page of its own.
  const std::string options = command == "play" ? page_of_play() : section("Options of " + command);
  const std::string of_command = entry(options, start, "\n\\.(It|El)");
  return of_command.empty() ? entry(section("Common options"), start, "\n\\.(It|El)") : of_command;
}

std::vector<const CommandRow*> commands_of(const OptionRow& row) {
  std::vector<const CommandRow*> list;
  for (const CommandRow& command : command_table()) {
    if (std::count(row.commands.begin(), row.commands.end(), command.command) > 0) {
      list.push_back(&command);
    }
  }
  return list;
}

/// The words of a text without the marks of the page and with single spaces.
std::set<std::string> words(const std::string& text) {
  std::set<std::string> found;
  std::istringstream stream(std::regex_replace(text, std::regex("[,.;:()]+(\\s|$)"), " "));
  for (std::string word; stream >> word;) found.insert(word);
  return found;
}

std::vector<std::string> arguments_for(const CommandRow& command) {
  std::vector<std::string> arguments{command.name};
  if (command.fewest_arguments > 0) arguments.emplace_back("scene.json");
  return arguments;
}

TEST(Help, EveryOptionIsInTheHelpAndInThePageOfItsCommand) {
  for (const OptionRow& row : option_table()) {
    for (const CommandRow* command : commands_of(row)) {
      const std::string text = help({command->name, "--help"});
      const std::string start = "\n      " + row.name + (row.value.empty() ? "" : ' ' + row.value);
      EXPECT_NE(entry(text, start, "\n {2,6}-"), "") << command->name << ' ' << row.name;
      EXPECT_NE(page_entry(command->name, row), "") << command->name << ' ' << row.name;
    }
  }
}

TEST(Help, TheValuesOfAChoiceAreInHelpPageAndParser) {
  std::size_t choices = 0;
  for (const OptionRow& row : option_table()) {
    if (row.rule.words.empty()) continue;
    ++choices;
    for (const CommandRow* command : commands_of(row)) {
      const auto in_help =
          words(entry(help({command->name, "--help"}), "\n      " + row.name, "\n {2,6}-"));
      const auto in_page = words(page_entry(command->name, row));
      std::vector<std::string> arguments = arguments_for(*command);
      arguments.push_back(row.name);
      for (const std::string& word : row.rule.words) {
        EXPECT_TRUE(in_help.contains(word)) << command->name << ' ' << row.name << ' ' << word;
        EXPECT_TRUE(in_page.contains(word)) << command->name << ' ' << row.name << ' ' << word;
        arguments.push_back(word);
        EXPECT_NO_THROW(parse_options(arguments))
            << command->name << ' ' << row.name << ' ' << word;
        arguments.back() += "x";
        try {
          parse_options(arguments);
          ADD_FAILURE() << row.name << " took " << arguments.back();
        } catch (const UsageError& error) {
          EXPECT_TRUE(std::string(error.what()).starts_with(row.name + ": must be "))
              << error.what();
          EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
        arguments.pop_back();
      }
    }
  }
  EXPECT_GE(choices, 2U);
}

TEST(Help, ThePageHasNoOptionThatIsNotInTheTable) {
  std::set<std::string> known{"--help", "--version"};
  for (const OptionRow& row : option_table()) known.insert(row.name);
  const std::string page = support::read_file(CAROM_SOURCE_DIR "/man/carom.1") + page_of_play();
  const std::regex item("\n\\.It Fl (?:[a-z] , )?(-[a-z-]+)");
  std::set<std::string> in_page;
  for (std::sregex_iterator it(page.begin(), page.end(), item), end; it != end; ++it) {
    in_page.insert('-' + (*it)[1].str());
  }
  EXPECT_EQ(in_page, known);
}

TEST(Help, EveryCommandIsInTheHelpAndInThePage) {
  const std::string page = support::read_file(CAROM_SOURCE_DIR "/man/carom.1");
  const std::string overview = help({"--help"});
  for (const CommandRow& row : command_table()) {
    const std::string argument = row.argument.empty() ? "" : ' ' + row.argument;
    EXPECT_NE(overview.find("\n  " + row.name + argument + ' '), std::string::npos) << row.name;
    EXPECT_NE(page.find("\n.It Cm " + row.name), std::string::npos) << row.name;
    EXPECT_NE(page.find("\n.Cm " + row.name + '\n'), std::string::npos) << row.name;
  }
}

TEST(Help, TheCommandHelpPrintsTheSame) {
  EXPECT_EQ(help({"help"}), help({"--help"}));
  for (const CommandRow& row : command_table()) {
    EXPECT_EQ(help({"help", row.name}), help({row.name, "--help"}));
  }
  EXPECT_NE(help({"help", "run"}), help({"help", "check"}));
}

TEST(Help, FitsEightyColumns) {
  std::string every = help({"--help"});
  for (const CommandRow& row : command_table()) every += help({row.name, "--help"});
  std::istringstream lines(every);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(Help, TheVersionIsOneLine) {
  EXPECT_TRUE(
      std::regex_match(support::run({CAROM_PROGRAM, "--version"}).out,
                       std::regex("carom [0-9]+\\.[0-9]+\\.[0-9]+( \\(commit [0-9a-f]+\\))?\n")));
  EXPECT_EQ(help({"run", "--version"}), help({"--version"}));
}

}  // namespace
}  // namespace carom::help_test
