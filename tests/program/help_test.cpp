// The help and the manual page say the same.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

#include "support/process.hpp"

namespace carom {
namespace {

std::set<std::string> found(const std::string& text, const std::regex& pattern) {
  std::set<std::string> names;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
    names.insert((*it)[1]);
  }
  return names;
}

std::string help(const std::vector<std::string>& command) {
  std::vector<std::string> words{CAROM_PROGRAM};
  words.insert(words.end(), command.begin(), command.end());
  words.emplace_back("--help");
  const auto outcome = support::run(words);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

std::string every_help() {
  return help({}) + help({"play"}) + help({"run"}) + help({"accuracy"}) + help({"check"}) +
         help({"verify"});
}

std::string page() {
  return support::read_file(CAROM_SOURCE_DIR "/man/carom.1");
}

TEST(Help, EveryOptionIsInThePageAndTheOtherWayRound) {
  const auto in_help = found(every_help(), std::regex("\n(?:  -[a-z],|     ) --([a-z-]+)"));
  const auto in_page = found(page(), std::regex("\n\\.It Fl (?:[a-z] , )?-([a-z-]+)"));
  EXPECT_GE(in_help.size(), 15U);
  EXPECT_EQ(in_help, in_page);
}

TEST(Help, AnOptionsValueIsCalledTheSameInThePage) {
  const auto in_help = found(every_help(), std::regex("\n {6}--([a-z-]+ [A-Zx]+)  "));
  const std::string without_markup = std::regex_replace(page(), std::regex(" Ar "), " ");
  EXPECT_GE(in_help.size(), 10U);
  EXPECT_EQ(in_help, found(without_markup, std::regex("\n\\.It Fl -([a-z-]+ [A-Zx]+)(?=\n)")));
}

TEST(Help, EveryCommandIsInThePage) {
  const auto in_help = found(help({}), std::regex("\n  ([a-z]+) \\[?SCENE"));
  EXPECT_EQ(in_help, found(page(), std::regex("\n\\.It Cm ([a-z]+) (?:Op )?Ar SCENE")));
  EXPECT_EQ(in_help, (std::set<std::string>{"accuracy", "check", "play", "run"}));
}

TEST(Help, FitsEightyColumns) {
  std::istringstream lines(every_help());
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(Help, TheVersionIsOneLine) {
  EXPECT_TRUE(std::regex_match(support::run({CAROM_PROGRAM, "--version"}).out,
                               std::regex("carom [0-9]+\\.[0-9]+\\.[0-9]+\n")));
}

}  // namespace
}  // namespace carom
