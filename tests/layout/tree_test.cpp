// What stands at the top of the tree, and that the tools of the house find nothing to say.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "support/process.hpp"

namespace carom::tree_test {
namespace {

namespace fs = std::filesystem;

const fs::path kTop = CAROM_SOURCE_DIR;

std::vector<std::string> files_below(const std::string& folder,
                                     const std::set<std::string>& extensions) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(kTop / folder)) {
    if (extensions.contains(entry.path().extension())) files.push_back(entry.path());
  }
  return files;
}

support::Outcome run_tool(const std::string& command, const std::vector<std::string>& files) {
  std::vector<std::string> words{"/bin/sh", "-c", "exec " + command + " \"$@\"", "sh"};
  words.insert(words.end(), files.begin(), files.end());
  return support::run(words, {kTop, ""});
}

TEST(Tree, TheTopHoldsNothingBesidesWhatBelongsThere) {
  const std::set<std::string> belongs{
      "CMakeLists.txt", "app", "engine", "tests", "scenes", "man", "README.md", "LICENSE",
      "CITATION.cff", ".gitignore", "CHANGELOG.md", ".ci", ".github", ".clang-tidy",
      "CMakePresets.json", ".clang-format",
      // A checkout's own: the history, and what .gitignore leaves out.
      ".git", "build"};
  for (const std::string& name : support::names_in(kTop)) {
    EXPECT_TRUE(belongs.contains(name)) << name;
  }
}

TEST(Tree, TheVersionIsTheSameEverywhere) {
  const std::string build = support::read_file(kTop / "CMakeLists.txt");
  std::smatch version;
  ASSERT_TRUE(std::regex_search(build, version, std::regex("project\\(carom VERSION ([0-9.]+)")));
  const std::string citation = support::read_file(kTop / "CITATION.cff");
  EXPECT_NE(citation.find("\nversion: " + version[1].str() + "\n"), std::string::npos);
  const std::string changes = support::read_file(kTop / "CHANGELOG.md");
  EXPECT_NE(changes.find("\n## " + version[1].str()), std::string::npos);
}

// So that the tests of a folder can be compiled together, whatever they call their own things.
TEST(Tree, EveryFileOfTestsHasItsNamesInANamespaceOfItsOwn) {
  const std::regex of_tests("\n(TEST|TEST_F|TEST_P|RC_GTEST_PROP)\\(");
  std::size_t found = 0;
  for (const std::string& file : files_below("tests", {".cpp"})) {
    const std::string text = support::read_file(file);
    if (!std::regex_search(text, of_tests)) continue;
    ++found;
    const std::string own = fs::path(file).stem().string() + " {\n";
    EXPECT_TRUE(text.find("::" + own) != std::string::npos) << file;
  }
  EXPECT_GE(found, 150U);
}

TEST(Tree, ClangFormatHasNothingToChange) {
  std::vector<std::string> files;
  for (const char* folder : {"engine", "app", "tests"}) {
    const auto more = files_below(folder, {".cpp", ".hpp"});
    files.insert(files.end(), more.begin(), more.end());
  }
  ASSERT_GT(files.size(), 40U);
  const auto outcome = run_tool("clang-format-14 --dry-run --Werror", files);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(Tree, LabelsOfCommentsBeginTheirLines) {
  const std::regex inside("[ \t]*//+.*[^/ ] +(Holds|Errors|Threads|Source|Units|REQUIRES): .*");
  for (const char* folder : {"engine", "app", "tests"}) {
    for (const std::string& file : files_below(folder, {".cpp", ".hpp"})) {
      std::istringstream lines(support::read_file(file));
      std::string line;
      for (int number = 1; std::getline(lines, line); ++number) {
        EXPECT_FALSE(std::regex_match(line, inside)) << file << ':' << number << ": " << line;
      }
    }
  }
}

TEST(Tree, MandocFindsNothingToSayAboutThePages) {
  const auto pages = files_below("man", {".1", ".5", ".7"});
  ASSERT_FALSE(pages.empty());
  const auto outcome = run_tool("mandoc -T lint", pages);
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_EQ(outcome.status, 0);
}

}  // namespace
}  // namespace carom::tree_test
