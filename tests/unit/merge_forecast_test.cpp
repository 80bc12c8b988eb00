#include "solvers/event/groups/merge_forecast.hpp"

#include <gtest/gtest.h>

#include "solvers/event/groups/conflict_groups.hpp"
#include "support/event_setting.hpp"

namespace carom::event::merge_forecast_test {
namespace {

TEST(MergeForecast, JoinsNothingWhereNothingIsSolvedAgain) {
  MergeForecast forecast;
  for (int window = 0; window < 3; ++window) {
    EXPECT_FALSE(forecast.joins_near());
    forecast.end_window(100);
  }
}

TEST(MergeForecast, JoinsWhatIsNearAfterMuchWasSolvedAgain) {
  MergeForecast forecast;
  forecast.add_solved_again(30);
  EXPECT_FALSE(forecast.joins_near()) << "not in the window that shows it";
  forecast.end_window(100);
  EXPECT_TRUE(forecast.joins_near());
}

TEST(MergeForecast, LeavesAloneWhatIsSolvedAgainAsASmallPart) {
  MergeForecast forecast;
  forecast.add_solved_again(20);
  forecast.end_window(100);
  EXPECT_FALSE(forecast.joins_near());
}

// Joined balls show no longer whether they would have merged.
TEST(MergeForecast, LooksAgainAfterSomeWindows) {
  MergeForecast forecast;
  forecast.add_solved_again(100);
  forecast.end_window(100);
  int windows = 0;
  while (forecast.joins_near() && windows < 1000) {
    forecast.end_window(100);
    ++windows;
  }
  EXPECT_GT(windows, 4);
  EXPECT_LT(windows, 100);
}

/// Eight columns of balls that fall, each a little beside the one below.
Setting falling_heap() {
  Setting setting;
  Rules& rules = setting.rules;
  Box box;
  box.width = 8;
  box.height = 16;
  rules.domain = carom::Domain(box, true);
  rules.scale = FixedTimeClock(0.25);
  rules.falls = true;
  rules.gravity = {0, -9.81};
  rules.rests = true;
  rules.restitution = rules.wall_restitution = 0.3;
  rules.all_species = {{0.4, 1}};
  Draw draw(5);
  for (int row = 0; row < 12; ++row) {
    for (int column = 0; column < 8; ++column) {
      Disk disk;
      disk.x = 0.5 + column + draw.number(-0.08, 0.08);
      disk.y = 0.5 + 1.25 * row + draw.number(-0.08, 0.08);
      setting.disks.push_back(disk);
    }
  }
  return setting;
}

// One pass finds what meets, and one that nothing else does: a heap under a rain of balls needs few
// more, though each impact on it sends others another way.
TEST(MergeForecast, SolvesAHeapThatIsHitOnce) {
  const Setting setting = falling_heap();
  ConflictGroups<Ballistic> groups(setting.rules);
  groups.set_workers(2);
  groups.reset(setting.disks, 0, {}, {});
  constexpr int kFrames = 60;
  for (int frame = 1; frame <= kFrames; ++frame) {
    advance(groups, setting.rules.scale.ticks(frame / 30.0), 2);
  }
  EXPECT_GT(groups.largest(), setting.disks.size() / 2) << "no heap";
  EXPECT_LT(static_cast<double>(groups.passes()), 2.25 * static_cast<double>(groups.windows()));
}

}  // namespace
}  // namespace carom::event::merge_forecast_test
