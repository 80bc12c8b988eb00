// The settings file: what it may say, and how the rest is refused.
#include "view/settings_file.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

#include "support/process.hpp"
#include "view/unused_name.hpp"

namespace carom::settings_file_test {
namespace {

using support::TemporaryFolder;

std::string refusal(const std::string& text) {
  const TemporaryFolder folder;
  support::write_file(folder / "config.json", text);
  try {
    (void)read_settings(folder / "config.json");
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    const std::string name = (folder / "config.json").string() + ": ";
    EXPECT_TRUE(message.starts_with(name)) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message.substr(name.size());
  }
  return "";
}

TEST(SettingsFile, SaysWhatItSays) {
  const TemporaryFolder folder;
  EXPECT_FALSE(read_settings(folder / "none").glyphs);
  EXPECT_FALSE(read_settings({}).fps);
  support::write_file(folder / "config.json",
                      R"({"glyphs": "blocks", "palette": "dark", "fps": 60, "mouse": false})");
  const StoredSettings settings = read_settings(folder / "config.json");
  EXPECT_EQ(settings.glyphs, Glyphs::blocks);
  EXPECT_EQ(settings.palette, Background::dark);
  EXPECT_EQ(settings.fps, 60);
  EXPECT_EQ(settings.mouse, false);
  EXPECT_EQ(refusal("{}"), "");
}

TEST(SettingsFile, RefusesBadValuesByTheirPointer) {
  EXPECT_EQ(refusal(R"({"glyphs": "block"})"),
            R"(/glyphs: must be "ascii", "blocks" or "braille", got "block")");
  EXPECT_EQ(refusal(R"({"palette": 3})"), R"(/palette: must be "any", "dark" or "light", got 3)");
  for (const char* const value : {"0", "121", "29.5", "\"30\"", "1e300", "-1"}) {
    EXPECT_EQ(refusal(std::string(R"({"fps": )") + value + '}')
                  .rfind("/fps: must be a whole number from 1 to 120, got ", 0),
              0U)
        << value;
  }
  EXPECT_EQ(refusal(R"({"mouse": "no"})"), R"(/mouse: must be true or false, got "no")");
  EXPECT_EQ(refusal(R"({"glyph": "blocks"})"), "/glyph: unknown key, the nearest one is glyphs");
  EXPECT_EQ(refusal("[]"), "must be a JSON object");
  EXPECT_TRUE(refusal("{\"fps\": 30,\n  nonsense}").starts_with("line 2, column "));
  EXPECT_NE(refusal(""), "");
}

TEST(SettingsFile, RemembersGlyphsAndKeepsTheRest) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "new/carom/config.json";
  remember_glyphs(file, Glyphs::braille);
  EXPECT_EQ(read_settings(file).glyphs, Glyphs::braille);
  support::write_file(file, R"({"fps": 20, "glyphs": "ascii"})");
  remember_glyphs(file, Glyphs::blocks);
  EXPECT_EQ(read_settings(file).glyphs, Glyphs::blocks);
  EXPECT_EQ(read_settings(file).fps, 20);
}

TEST(UnusedName, IsPlainAndNotTaken) {
  const TemporaryFolder folder;
  const std::string where = folder.path().string();
  EXPECT_EQ(unused_name(where, "a gas: ../hot", ".json"), where + "/a-gas-hot-1.json");
  EXPECT_EQ(unused_name(where, "", ".cast"), where + "/carom-1.cast");
  support::write_file(folder / "carom-1.cast", "");
  EXPECT_EQ(unused_name(where, "..", ".cast"), where + "/carom-2.cast");
}

}  // namespace
}  // namespace carom::settings_file_test
