// Other scenes, files that keys write, and the settings file, through a terminal.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "scenes.hpp"
#include "steps.hpp"
#include "support/process.hpp"
#include "terminal.hpp"

namespace carom::test::picker_test {
namespace {

using Json = nlohmann::json;

Json report_of(const std::string& scene, const support::TemporaryFolder& folder,
               const std::vector<std::string>& more) {
  std::vector<std::string> words{CAROM_PROGRAM, "run",      scene,
                                 "--quiet",     "--report", (folder / "report.json").string()};
  words.insert(words.end(), more.begin(), more.end());
  const support::Outcome run = support::run(words);
  EXPECT_EQ(run.status, 0) << run.err;
  return Json::parse(support::read_file(folder / "report.json"));
}

TEST(Picker, ShowsWhatAScenesIsAboutAndPlaysIt) {
  Terminal terminal(std::vector<std::string>{});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  terminal.type("\t");
  ASSERT_TRUE(terminal.wait_for("scenes, ")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("Enter: play it")) << terminal.text();
  EXPECT_TRUE(terminal.shows(" gas ")) << terminal.text();
  terminal.type("c");
  terminal.type("c");
  terminal.type("c");
  // The third name from "break" on that begins with c: channel, collisions, cradle.
  const Json cradle = Json::parse(support::read_file(CAROM_SOURCE_DIR "/scenes/cradle.json"));
  const std::string about = cradle["about"];
  EXPECT_TRUE(terminal.wait_for(about.substr(0, 20))) << terminal.text();
  EXPECT_TRUE(terminal.wait([](const Terminal& t) {
    return t.text().find("+-----") != t.text().rfind("+-----");  // a box beside the list
  })) << terminal.text();
  terminal.type("\r");
  EXPECT_TRUE(terminal.wait_for(" cradle  ")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("scene cradle")) << terminal.text();
  EXPECT_NE(terminal.output().find("\x1B]2;carom: cradle\a"), std::string::npos);
  terminal.type("\t");
  ASSERT_TRUE(terminal.wait_for("scenes, ")) << terminal.text();
  terminal.type("\x1B");
  EXPECT_TRUE(terminal.wait([](const Terminal& t) { return !t.shows("scenes, "); }));
  expect_end_by_key(terminal);
}

TEST(Files, KeysSaveAndRecordAndTheLogEndsInTheSavedBits) {
  const support::TemporaryFolder folder;
  const SceneFile scene(kThreeBalls);
  Terminal::Settings settings;
  settings.folder = folder.path().string();
  Terminal terminal({scene.path(), "--log", "log.json"}, settings);
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  terminal.type("o");
  ASSERT_TRUE(terminal.wait_for("recording: o ends it")) << terminal.text();
  terminal.type("a");
  ASSERT_TRUE(terminal.wait_for("added a ball")) << terminal.text();
  terminal.type("o");
  ASSERT_TRUE(terminal.wait_for("recorded ./three-1.cast")) << terminal.text();
  terminal.type("p");
  ASSERT_TRUE(terminal.wait_for("paused: ")) << terminal.text();
  // A way back that ends where it was: the same bits.
  terminal.type(",,,,,,,,");
  ASSERT_TRUE(terminal.wait_for("back to")) << terminal.text();
  terminal.type("........");
  ASSERT_TRUE(terminal.wait_for("8 frames")) << terminal.text();
  terminal.type("s");
  ASSERT_TRUE(terminal.wait_for("saved as ./three-1.json")) << terminal.text();
  terminal.type("s");
  ASSERT_TRUE(terminal.wait_for("saved as ./three-2.json")) << terminal.text();
  terminal.type("q");
  EXPECT_EQ(terminal.wait_for_end(), 0);
  const Json saved = report_of((folder / "three-1.json").string(), folder, {"--time", "0"});
  const Json logged = report_of((folder / "log.json").string(), folder, {});
  EXPECT_EQ(saved["balls"], 4);
  EXPECT_EQ(saved["state_hash"], logged["state_hash"]);
  EXPECT_EQ(saved["time"], logged["time"]);
  EXPECT_TRUE(support::read_file(folder / "three-1.cast").starts_with("{\"version\": 2"));
}

TEST(SettingsOfPlay, AreReadAndTheGlyphsOfAKeyAreRemembered) {
  const support::TemporaryFolder folder;
  const SceneFile scene(kThreeBalls);
  std::filesystem::create_directory(folder / "carom");
  const std::filesystem::path file = folder / "carom/config.json";
  support::write_file(file, R"({"mouse": false, "glyphs": "braille"})");
  Terminal::Settings settings;
  settings.environment.push_back("XDG_CONFIG_HOME=" + folder.path().string());
  {
    Terminal terminal({scene.path()}, settings);
    ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
    EXPECT_EQ(terminal.count("\x1B[?1002h"), 0U);
    terminal.type("bb");
    ASSERT_TRUE(terminal.wait_for("glyphs blocks")) << terminal.text();
    terminal.type("q");
    EXPECT_EQ(terminal.wait_for_end(), 0);
  }
  EXPECT_EQ(Json::parse(support::read_file(file)),
            Json::parse(R"({"mouse": false, "glyphs": "blocks"})"));
  support::write_file(file, R"({"fps": 500})");
  Terminal refused({scene.path()}, settings);
  EXPECT_EQ(refused.wait_for_end(), 2);
  EXPECT_EQ(refused.output().find('\x1B'), std::string::npos);
  std::string told = refused.output();
  EXPECT_NE(told.find("/carom/config.json: /fps: must be a whole number from 1 to 120, got 500"),
            std::string::npos)
      << told;
}

}  // namespace
}  // namespace carom::test::picker_test
