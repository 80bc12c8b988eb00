// A cast that a run writes shows what its dump shows.
#include <gtest/gtest.h>
#include <vterm.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "support/process.hpp"

namespace carom {
namespace {

using Json = nlohmann::json;

/// A terminal without a program: what it shows of bytes that come.
class Shown {
 public:
  Shown(int columns, int rows)
      : columns_(columns), rows_(rows), terminal_(vterm_new(rows, columns)) {
    vterm_set_utf8(terminal_, 1);
    screen_ = vterm_obtain_screen(terminal_);
    vterm_screen_reset(screen_, 1);
  }
  ~Shown() { vterm_free(terminal_); }
  Shown(const Shown&) = delete;
  Shown& operator=(const Shown&) = delete;

  void write(const std::string& bytes) { vterm_input_write(terminal_, bytes.data(), bytes.size()); }
  [[nodiscard]] std::string text() const {
    std::string all;
    for (int row = 0; row < rows_; ++row) {
      std::string line;
      for (int column = 0; column < columns_; ++column) {
        VTermScreenCell cell;
        vterm_screen_get_cell(screen_, {row, column}, &cell);
        line += cell.chars[0] == 0 ? ' ' : static_cast<char>(cell.chars[0]);
      }
      line.erase(line.find_last_not_of(' ') + 1);
      all += line + '\n';
    }
    return all;
  }

 private:
  int columns_;
  int rows_;
  VTerm* terminal_;
  VTermScreen* screen_ = nullptr;
};

TEST(Cast, ReplayedShowsTheFramesOfTheDump) {
  const support::TemporaryFolder folder;
  support::write_file(folder / "scene.json", R"({"name": "a \"cast\"",
    "box": {"width": 20, "height": 10}, "frame_rate": 20, "duration": 4,
    "effects": {"walls": {}, "collisions": {}, "gravity": [0, -5]},
    "fill": [{"count": 12, "radius": 0.6, "temperature": 4}],
    "script": [{"at": 1, "command": "pause"}, {"at": 2, "command": "resume"}]})");
  const support::Outcome outcome = support::run(
      {CAROM_PROGRAM, "run", (folder / "scene.json").string(), "--quiet", "--size", "60x17",
       "--cast", (folder / "cast").string(), "--dump", (folder / "dump").string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;

  std::istringstream lines(support::read_file(folder / "cast"));
  std::string line;
  std::getline(lines, line);
  const Json header = Json::parse(line);
  EXPECT_EQ(header["version"], 2);
  EXPECT_EQ(header["width"], 60);
  EXPECT_EQ(header["height"], 17);
  EXPECT_EQ(header["title"], "a \"cast\"");
  std::multimap<double, std::string> output;
  double last = 0;
  std::size_t bytes = 0;
  while (std::getline(lines, line)) {
    const Json event = Json::parse(line);
    ASSERT_EQ(event.size(), 3U);
    EXPECT_EQ(event[1], "o");
    EXPECT_GE(double(event[0]), last);
    last = event[0];
    bytes += std::string(event[2]).size();
    output.emplace(last, event[2]);
  }

  Shown shown(60, 17);
  auto next = output.begin();
  std::istringstream dump(support::read_file(folder / "dump"));
  std::size_t frames = 0;
  std::getline(dump, line);
  while (dump) {
    const double clock = std::stod(line.substr(8)) / 20;
    std::string picture;
    while (std::getline(dump, line) && !line.starts_with("# frame")) picture += line + '\n';
    for (; next != output.end() && next->first <= clock + 1e-6; ++next) shown.write(next->second);
    EXPECT_EQ(shown.text(), picture) << "frame " << frames;
    ++frames;
  }
  EXPECT_EQ(frames, 101U);
  EXPECT_EQ(next, output.end());
  EXPECT_LT(bytes, frames * 60 * 17 / 4);  // of cells that have changed
}

}  // namespace
}  // namespace carom
