#include "view/status.hpp"

#include <gtest/gtest.h>

#include "view/keys.hpp"
#include "view/meter.hpp"

namespace carom::status_test {
namespace {

Status busy() {
  Status status;
  status.scene = "a gas of many balls";
  status.balls = 1000;
  status.workers = 1000;
  status.time = 1234.56;
  status.frames_per_second = 29.97;
  status.computing_milliseconds = 12.34;
  status.energy_error = -1.25e-13;
  status.late = 17;
  status.pace = 0.4;
  return status;
}

TEST(StatusLine, SaysEverythingWhereThereIsRoom) {
  EXPECT_EQ(
      status_line(busy(), 200),
      " a gas of many balls  1000 balls  1000 workers  1234.56 s  too slow: 0.4x of 1x  30 fps"
      "  17 frames late  computing 12.3 ms  energy error 1e-13");
}

TEST(StatusLine, LeavesOutAtEightyColumnsWhatMattersLeastAndAbbreviatesNothing) {
  EXPECT_EQ(status_line(busy(), 80),
            " a gas of many balls  1000 balls  1234.56 s  too slow: 0.4x of 1x  30 fps");
  Status status = busy();
  status.late = 0;
  status.pace.reset();
  EXPECT_EQ(status_line(status, 80),
            " a gas of many balls  1000 balls  1234.56 s  1x  30 fps  energy error 1e-13");
}

TEST(StatusLine, SaysWhyOverlapWasChosenAtEightyColumns) {
  Status status = busy();
  status.note = "overlap: more than 300 balls can pile up";
  EXPECT_NE(status_line(status, 80).find(status.note), std::string::npos);
  EXPECT_NE(status_line(status, 200).find(status.note), std::string::npos);
}

TEST(StatusLine, NeverIsWiderThanItsScreen) {
  for (int width = -1; width < 160; ++width)
    EXPECT_LE(static_cast<int>(status_line(busy(), width).size()), std::max(0, width));
  EXPECT_NE(status_line(busy(), 20).find("1234.56 s"), std::string::npos);
}

TEST(StatusLine, WritesSpeedsAsPeopleDo) {
  EXPECT_EQ(speed_text(1), "1x");
  EXPECT_EQ(speed_text(8), "8x");
  EXPECT_EQ(speed_text(0.25), "1/4x");
}

TEST(KeyHints, NameEveryKeyThatIsOfUseAtEightyColumns) {
  for (const bool paused : {false, true}) {
    for (const std::string effects : {"", "wcg"}) {
      if (paused && !effects.empty()) continue;
      const std::string hints = hint_line(key_hints(80, paused, effects));
      EXPECT_LE(hints.size(), 80U);
      for (const char* const key : {"space", "a:", "x:", "r:", "+-", "b:", "?", "q:"})
        EXPECT_NE(hints.find(key), std::string::npos) << key << " in " << hints;
      EXPECT_EQ(hints.find(" wcg:") != std::string::npos, !effects.empty());
    }
  }
}

TEST(KeyHints, HaveTheKeysOfTheEffectsThatAreNamed) {
  Effects effects;
  EXPECT_EQ(effect_keys(effects), "");
  effects.gravity = Gravity{};
  effects.walls = Walls{};
  effects.attraction = Attraction{};
  EXPECT_EQ(effect_keys(effects), "wgt");
}

TEST(KeyHints, KeepTheWayOutLongest) {
  EXPECT_EQ(hint_line(key_hints(8, false, "wcgdft")), " q:quit");
  for (int width = -1; width < 100; ++width)
    EXPECT_LE(static_cast<int>(hint_line(key_hints(width, true, "wcgdft")).size()),
              std::max(0, width));
}

TEST(Meter, TellsTheRateOfTheLastSecond) {
  Meter meter;
  EXPECT_FALSE(meter.pace());
  EXPECT_EQ(meter.frames_per_second(), 0);
  for (int i = 0; i < 100; ++i) {
    meter.record(Instant{} + std::chrono::milliseconds{25 * i}, 0.01 * i,
                 std::chrono::milliseconds{i < 50 ? 100 : 7});
  }
  EXPECT_NEAR(meter.frames_per_second(), 40, 1e-9);
  EXPECT_NEAR(meter.computing_milliseconds(), 7, 1e-9);
  EXPECT_NEAR(meter.pace().value_or(0), 0.4, 1e-9);
}

}  // namespace
}  // namespace carom::status_test
