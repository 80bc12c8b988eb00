// Golden cases: each folder beside this file is one run of the program.
//
//   arguments  the command line, in words as a shell splits them
//   input      its standard input (none: empty)
//   out        what it must write to standard output (none: nothing)
//   err        what it must write to standard error (none: nothing)
//   status     its exit status (none: 0)
//   written/   the files it must leave behind; it must leave no others
//
// Every other file is there while it runs.  Wall-clock times, the version and the state's hash are
// masked by the rules below, in what is expected and in what is found.  The cases hold the format;
// what moves in them can be worked out by hand.
#include <gtest/gtest.h>
#include <wordexp.h>

#include <array>
#include <regex>
#include <set>

#include "support/process.hpp"

namespace carom::golden_test {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = CAROM_SOURCE_DIR "/tests/golden";
const std::set<std::string> kOwn{"arguments", "input", "out", "err", "status", "written"};

std::string masked(std::string text) {
  static const std::array kRules{
      // The summary: "  wall clock   0.012 s", and the same for every phase and effect.
      std::pair{std::regex("(  (wall clock|(phase|effect) [a-z_]+) +)[0-9.*]+ s\n"), "$1* s\n"},
      // The report: seconds of the whole and of an effect; those of the phases below.
      std::pair{std::regex("\"(wall_seconds|seconds)\": [-+0-9.e]+"), "\"$1\": *"},
      std::pair{std::regex("\"state_hash\": \"[0-9a-f]+\""), "\"state_hash\": \"*\""},
      std::pair{std::regex("\"version\": \"[0-9.]+\""), "\"version\": \"*\""},
      std::pair{std::regex("carom [0-9]+\\.[0-9]+\\.[0-9]+( \\(commit [0-9a-f]+\\))?\n"),
                "carom *\n"},
  };
  for (const auto& [pattern, replacement] : kRules) {
    text = std::regex_replace(text, pattern, replacement);
  }
  std::smatch phases;
  if (std::regex_search(text, phases, std::regex("\"phases\": \\{[^}]*\\}"))) {
    const std::string seconds =
        std::regex_replace(phases.str(), std::regex("\": [-+0-9.e]+"), "\": *");
    text = phases.prefix().str() + seconds + phases.suffix().str();
  }
  return text;
}

std::string text_or(const fs::path& file, const std::string& otherwise) {
  return fs::exists(file) ? support::read_file(file) : otherwise;
}

std::vector<std::string> words_of(const fs::path& file) {
  std::string text = support::read_file(file);
  text.erase(text.find_last_not_of('\n') + 1);
  wordexp_t words{};
  if (wordexp(text.c_str(), &words, WRDE_NOCMD | WRDE_UNDEF) != 0) {
    throw std::runtime_error("not a command line: " + file.string());
  }
  std::vector<std::string> result(words.we_wordv, words.we_wordv + words.we_wordc);
  wordfree(&words);
  return result;
}

std::vector<std::string> cases() {
  std::vector<std::string> names;
  for (const std::string& name : support::names_in(kCases)) {
    if (fs::is_directory(kCases / name)) names.push_back(name);
  }
  return names;
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, RunsAsExpected) {
  const fs::path expected = kCases / GetParam();
  const support::TemporaryFolder folder;
  std::set<std::string> names;
  for (const std::string& name : support::names_in(expected)) {
    if (kOwn.contains(name)) continue;
    fs::copy(expected / name, folder / name);
    names.insert(name);
  }

  std::vector<std::string> words = words_of(expected / "arguments");
  words.insert(words.begin(), CAROM_PROGRAM);
  const auto outcome = support::run(words, {folder.path(), text_or(expected / "input", "")});

  EXPECT_EQ(masked(outcome.out), masked(text_or(expected / "out", "")));
  EXPECT_EQ(masked(outcome.err), masked(text_or(expected / "err", "")));
  EXPECT_EQ(outcome.status, std::stoi(text_or(expected / "status", "0")));
  if (fs::exists(expected / "written")) {
    for (const std::string& name : support::names_in(expected / "written")) {
      names.insert(name);
      ASSERT_TRUE(fs::exists(folder / name)) << name << " was not written";
      EXPECT_EQ(masked(support::read_file(folder / name)),
                masked(support::read_file(expected / "written" / name)))
          << "in " << name;
    }
  }
  EXPECT_EQ(support::names_in(folder.path()), std::vector<std::string>(names.begin(), names.end()))
      << "files left behind";
}

INSTANTIATE_TEST_SUITE_P(Cases, Golden, testing::ValuesIn(cases()),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace carom::golden_test
