// The completion scripts offer in each shell what the tables say, and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <set>
#include <sstream>

#include "completions/completions.hpp"
#include "support/process.hpp"

namespace carom::completions_test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const fs::path kScripts = CAROM_COMPLETIONS;

/// What a shell offers where the last word of a line is being written.
struct Shell {
  std::string name;
  std::set<std::string> (*offers)(const Words& line);
};

void PrintTo(const Shell& shell, std::ostream* out) {
  *out << shell.name;
}

std::set<std::string> first_words(const std::string& text) {
  std::set<std::string> words;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) words.insert(line.substr(0, line.find('\t')));
  words.erase("");
  return words;
}

std::string joined(const Words& line) {
  std::string text;
  for (const std::string& word : line) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// A shell runs in a folder with one file, and the program is found by its name.
std::set<std::string> run_shell(const Words& words) {
  const support::TemporaryFolder folder;
  support::write_file(folder / "file.txt", "");
  const std::string path =
      "PATH=" + fs::path(CAROM_PROGRAM).parent_path().string() + ":/usr/bin:/bin";
  Words all{"/usr/bin/env", path, "HOME=" + folder.path().string()};
  all.insert(all.end(), words.begin(), words.end());
  const support::Outcome outcome = support::run(all, {folder.path(), ""});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return first_words(outcome.out);
}

std::set<std::string> bash_offers(const Words& line) {
  Words words{"bash",
              "--norc",
              "-c",
              "source \"$1\"; shift; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _carom; "
              "printf '%s\\n' \"${COMPREPLY[@]}\"",
              "bash",
              kScripts / "bash" / "carom"};
  words.insert(words.end(), line.begin(), line.end());
  return run_shell(words);
}

std::set<std::string> zsh_offers(const Words& line) {
  return run_shell({"zsh", "-f", CAROM_SOURCE_DIR "/tests/program/complete.zsh", kScripts / "zsh",
                    joined(line)});
}

std::set<std::string> fish_offers(const Words& line) {
  return run_shell({"fish", "--no-config", "-c",
                    "source " + (kScripts / "fish" / "carom.fish").string() + "; complete -C '" +
                        joined(line) + "'"});
}

class Completions : public ::testing::TestWithParam<Shell> {
 protected:
  void SetUp() override {
    if (support::run({"/bin/sh", "-c", "command -v " + GetParam().name}).status != 0) {
      GTEST_SKIP() << GetParam().name << " is not installed";
    }
  }

  [[nodiscard]] static std::set<std::string> offers(const Words& line) {
    return GetParam().offers(line);
  }
};

TEST_P(Completions, OfferTheOptionsOfEachCommand) {
  for (const CommandRow& command : command_table()) {
    std::set<std::string> expected{"--help", "--version"};
    for (const OptionRow& row : option_table()) {
      if (takes(command, row)) expected.insert(row.name);
    }
    std::set<std::string> offered;
    for (const std::string& word : offers({"carom", command.name, "--"})) {
      offered.insert(word.substr(0, word.find('=')));
    }
    EXPECT_EQ(offered, expected) << command.name;
  }
}

TEST_P(Completions, OfferTheValuesOfEachChoice) {
  for (const OptionRow& row : option_table()) {
    if (row.rule.words.empty()) continue;
    const auto command = std::find_if(command_table().begin(), command_table().end(),
                                      [&](const CommandRow& each) { return takes(each, row); });
    const std::set<std::string> expected(row.rule.words.begin(), row.rule.words.end());
    EXPECT_EQ(offers({"carom", command->name, row.name, ""}), expected) << row.name;
  }
}

TEST_P(Completions, OfferTheCommandsFirst) {
  const auto offered = offers({"carom", ""});
  for (const CommandRow& command : command_table()) {
    EXPECT_TRUE(offered.contains(command.name)) << command.name;
  }
  EXPECT_TRUE(offered.contains("galton"));
  EXPECT_TRUE(offered.contains("file.txt"));
  EXPECT_EQ(offers({"carom", "help", "acc"}), std::set<std::string>{"accuracy"});
}

TEST_P(Completions, OfferScenesFilesAndCases) {
  EXPECT_EQ(offers({"carom", "run", "galt"}), std::set<std::string>{"galton"});
  EXPECT_EQ(offers({"carom", "run", "fil"}), std::set<std::string>{"file.txt"});
  EXPECT_EQ(offers({"carom", "run", "--report", ""}), std::set<std::string>{"file.txt"});
  EXPECT_EQ(offers({"carom", "verify", "--case", "thr"}), std::set<std::string>{"three-way"});
  EXPECT_EQ(offers({"carom", "run", "--seed", ""}), std::set<std::string>{});
}

INSTANTIATE_TEST_SUITE_P(, Completions,
                         ::testing::Values(Shell{"bash", bash_offers}, Shell{"zsh", zsh_offers},
                                           Shell{"fish", fish_offers}),
                         [](const auto& shell) { return shell.param.name; });

}  // namespace
}  // namespace carom::completions_test
