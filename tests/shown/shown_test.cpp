// The commands that README, tutorials and manual pages show do what is shown there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <regex>

#include "option_table.hpp"
#include "shown/shown_commands.hpp"
#include "support/process.hpp"

namespace carom::shown::shown_test {
namespace {

namespace fs = std::filesystem;

const fs::path kTop = CAROM_SOURCE_DIR;

std::vector<std::string> pages() {
  std::vector<std::string> found{"README.md"};
  for (const auto& entry : fs::recursive_directory_iterator(kTop / "man")) {
    const std::string extension = entry.path().extension();
    if (extension == ".md" || std::regex_match(extension, std::regex("\\.[1-9]"))) {
      found.push_back(fs::relative(entry.path(), kTop));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// A command that plays cannot run here: its scene is checked instead.
std::string without_play(const std::string& text) {
  std::smatch words;
  if (!std::regex_match(text, words, std::regex("carom(?: +(play))?(?: +([^-\\s]\\S*))?( .*)?"))) {
    return text;
  }
  const std::string word = words[2].matched ? words[2].str() : "break";
  const auto named = [&](const CommandRow& row) { return row.name == word; };
  const bool command = std::any_of(command_table().begin(), command_table().end(), named);
  return command && !words[1].matched ? text : "carom check " + word + " >/dev/null";
}

/// Blocks marked slow take minutes and need gnuplot; those marked tsan need a thread sanitizer that
/// runs here: some kernels place programs where it cannot.
bool can_run(const std::string& mark) {
  if (mark == "slow") {
    return std::getenv("CAROM_SLOW") != nullptr &&
           support::run({"/bin/sh", "-c", "command -v gnuplot"}).status == 0;
  }
  if (mark != "tsan") return true;
  const support::TemporaryFolder folder;
  support::write_file(folder / "empty.cpp", "int main() {}\n");
  const char* const build = "g++ -fsanitize=thread empty.cpp -o empty && ./empty";
  return support::run({"/bin/sh", "-c", build}, {folder.path(), ""}).status == 0;
}

class Page : public ::testing::TestWithParam<std::string> {};

TEST_P(Page, ShowsWhatItsCommandsGive) {
  const support::TemporaryFolder folder;
  const std::string path =
      fs::path(CAROM_PROGRAM).parent_path().string() + ":" + std::getenv("PATH");
  fs::create_directory_symlink(kTop / "scenes", folder / "scenes");
  for (const Command& command : commands_in(kTop / GetParam())) {
    if (!can_run(command.mark)) continue;
    const support::Outcome outcome =
        support::run({"/usr/bin/env", "PATH=" + path, "CAROM_SOURCES=" + kTop.string(), "bash",
                      "-c", without_play(command.text)},
                     {folder.path(), ""});
    const std::string where = GetParam() + ":" + std::to_string(command.line) + ": " + command.text;
    if (!command.with_output) {
      EXPECT_EQ(outcome.status, 0) << where << '\n' << outcome.out << outcome.err;
      continue;
    }
    EXPECT_TRUE(matches(command.output, lines_of(outcome.out + outcome.err)))
        << where << "\ngives\n"
        << outcome.out << outcome.err;
  }
}

INSTANTIATE_TEST_SUITE_P(, Page, ::testing::ValuesIn(pages()), [](const auto& page) {
  return std::regex_replace(page.param, std::regex("[^A-Za-z0-9]"), "_");
});

TEST(Shown, AReadmeOfOneScreenAndAHalf) {
  EXPECT_LE(lines_of(support::read_file(kTop / "README.md")).size(), 120U);
  EXPECT_GE(commands_in(kTop / "README.md").size(), 3U);
}

TEST(Shown, PicturesAreMadeFromTheProgram) {
  if (support::run({"/bin/sh", "-c", "command -v python3"}).status != 0) {
    GTEST_SKIP() << "python3 is not installed";
  }
  const support::TemporaryFolder folder;
  const support::Outcome outcome =
      support::run({kTop / "man/pictures/make", CAROM_PROGRAM, folder.path()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const std::string name : {"break.svg", "threads.svg", "chaos.svg"}) {
    const std::string picture = support::read_file(folder / name);
    EXPECT_TRUE(picture.starts_with("<svg ") && picture.ends_with("</svg>\n")) << name;
    EXPECT_LT(picture.size(), 100'000U) << name;
    EXPECT_TRUE(fs::exists(kTop / "man/pictures" / name)) << name;
  }
  // The other two hold measured times and the growth of rounding errors.
  EXPECT_EQ(support::read_file(folder / "break.svg"),
            support::read_file(kTop / "man/pictures/break.svg"))
      << "run man/pictures/make";
}

TEST(Shown, EveryManualPageHasExamples) {
  for (const std::string& page : pages()) {
    if (page.ends_with(".md")) continue;
    EXPECT_NE(support::read_file(kTop / page).find("\n.Sh EXAMPLES\n"), std::string::npos) << page;
  }
}

TEST(Shown, NumbersAreMaskedAndWordsAreNot) {
  EXPECT_EQ(masked("event, 16 digits    282 us  1.0e-01"),
            masked("event, 34 digits  1.5 ms  -3e+2"));
  EXPECT_NE(masked("overlap, 16"), masked("event, 16"));
  EXPECT_TRUE(matches({"a 1", "...", "b"}, {"a 2", "x", "y", "b"}));
  EXPECT_TRUE(matches({"...", "b"}, {"b"}));
  EXPECT_FALSE(matches({"a", "...", "b"}, {"a", "x"}));
  EXPECT_FALSE(matches({"a"}, {"a", "x"}));
}

TEST(Shown, LinksOfTheReadmeLeadSomewhere) {
  const std::string text = support::read_file(kTop / "README.md");
  const std::regex link("\\]\\(([^):#]+)\\)");
  std::size_t count = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it, ++count) {
    EXPECT_TRUE(fs::exists(kTop / (*it)[1].str())) << (*it)[1];
  }
  EXPECT_GT(count, 10U);
}

}  // namespace
}  // namespace carom::shown::shown_test
