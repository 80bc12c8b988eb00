#include "view/lanes.hpp"

#include <gtest/gtest.h>

#include "view/threads_panel.hpp"

namespace carom::lanes_test {
namespace {

/// Two workers, two phases, one frame: worker 0 computes 10 of 100 ns and 5, worker 1 20 and 30.
Timeline one_frame() {
  Timeline timeline;
  timeline.barriers = {"do_frame", "wall_computation", "pair_computation", "frame_done"};
  timeline.control = {{1000, 1012, 1105, 7, 0}};
  timeline.workers = {{{990, 990, 1010, 7, 0},
                       {1010, 1020, 1041, 7, 1},
                       {1041, 1046, 1091, 7, 2},
                       {1091, 1091, 1110, 7, 3}},
                      {{991, 991, 1020, 7, 0},
                       {1020, 1040, 1060, 7, 1},
                       {1060, 1090, 1092, 7, 2},
                       {1100, 1100, 1111, 7, 3}}};
  return timeline;
}

TEST(Lanes, TellWhenEachWorkerComputedAndWhenAllPassedABarrier) {
  const Lanes lanes = lanes_of(one_frame());
  EXPECT_EQ(lanes.begin, 1000);
  EXPECT_EQ(lanes.end, 1100) << "the last worker has arrived at frame_done";
  ASSERT_EQ(lanes.workers.size(), 2U);
  ASSERT_EQ(lanes.workers[1].size(), 2U);
  EXPECT_EQ(lanes.workers[1][0].begin, 1020);
  EXPECT_EQ(lanes.workers[1][0].end, 1040);
  ASSERT_EQ(lanes.passages.size(), 4U);
  const std::int64_t at[] = {1000, 1040, 1090, 1100};
  for (std::uint32_t k = 0; k < 4; ++k) {
    EXPECT_EQ(lanes.passages[k].barrier, k);
    EXPECT_EQ(lanes.passages[k].at, at[k]);
  }
  EXPECT_EQ(lanes.passages[1].last, 1U);
  EXPECT_EQ(most_often_last(lanes), 1U);
  // 15 and 50 of 100 ns each.
  EXPECT_DOUBLE_EQ(share_of_waiting(lanes), 1 - 65.0 / 200);
  EXPECT_DOUBLE_EQ(computing_in(lanes.workers[1], 1030, 1070), 20);
}

TEST(Lanes, OfSeveralFramesFollowEachOtherAndLeaveOutWorkersThatEnded) {
  Timeline timeline = one_frame();
  timeline.control.push_back({2000, 2001, 2050, 8, 0});
  timeline.workers[0].push_back({1110, 1110, 2005, 8, 0});
  timeline.workers[0].push_back({2005, 2030, 2030, 8, 1});
  timeline.workers[0].push_back({2040, 2040, 2050, 8, 3});
  const Lanes lanes = lanes_of(timeline);
  EXPECT_EQ(lanes.workers.size(), 1U);
  ASSERT_EQ(lanes.passages.size(), 7U);
  EXPECT_EQ(lanes.passages[4].barrier, 0U);
  EXPECT_EQ(lanes.passages[4].at, 2000);
  EXPECT_EQ(lanes.passages[6].barrier, 3U);
  EXPECT_EQ(lanes.end, 2040);
  const Lanes second = part_of(lanes, 2000, 2030);
  EXPECT_EQ(second.passages.size(), 2U);
  ASSERT_EQ(second.workers[0].size(), 1U);
  EXPECT_DOUBLE_EQ(share_of_waiting(second), 1 - 25.0 / 30);
}

TEST(Lanes, OfNothingAreEmpty) {
  EXPECT_TRUE(lanes_of({}).empty());
  EXPECT_EQ(share_of_waiting({}), 0);
}

TEST(Lanes, AreThoseOfTheBusiestWhereThereAreMany) {
  EXPECT_EQ(busiest({3, 9, 1, 9, 4}, 3), (std::vector<std::size_t>{1, 3, 4}));
  EXPECT_EQ(busiest({3, 9}, 5), (std::vector<std::size_t>{0, 1}));
}

std::string row_of(const Canvas& canvas, int row) {
  std::string text;
  for (int column = 0; column < canvas.columns; ++column)
    text += static_cast<char>(canvas.at(column, row).character);
  return text;
}

TEST(ThreadsPanel, DrawsALaneForEachThreadAndAMarkWhereAllPassed) {
  ThreadsView view{lanes_of(one_frame()), one_frame().barriers, {15, 50}, 1100, "threads", ""};
  // 60 inside, 9 of them for names: 51 cells of 1.96 ns.
  const Canvas panel = threads_panel(view, 62, 9, Glyphs::ascii);
  EXPECT_EQ(row_of(panel, 0), "+- threads --------------------------------------------------+");
  EXPECT_EQ(row_of(panel, 1), "|         do_frame            '                    frame_done|");
  EXPECT_EQ(row_of(panel, 2), "|control  #~~~~~~~~~~~~~~~~~~~|~~~~~~~~~~~~~~~~~~~~~~~~|~~~~||");
  EXPECT_EQ(row_of(panel, 3), "|worker 0 |~~~~#####+~~~~~~~~~|##+~~~~~~~~~~~~~~~~~~~~~|~~~~||");
  EXPECT_EQ(row_of(panel, 4), "|worker 1 |~~~~~~~~~##########|~~~~~~~~~+###############~~~~||");
  EXPECT_EQ(row_of(panel, 5), "|# computes  ~ waits   waiting 68 %                          |");
}

TEST(ThreadsPanel, KeepsWhatHasNotHappenedYetBlankAndSaysWhatIsGuaranteed) {
  ThreadsView view{lanes_of(one_frame()), one_frame().barriers, {15, 50}, 1040, "threads",
                   "all have flown"};
  const Canvas panel = threads_panel(view, 62, 12, Glyphs::ascii);
  EXPECT_EQ(row_of(panel, 4).find_last_of("#~|", 60), 30U) << row_of(panel, 4);
  EXPECT_NE(row_of(panel, 6).find("all have flown"), std::string::npos);
  for (int row = 0; row < panel.rows; ++row)
    EXPECT_EQ(row_of(panel, row).find("frame_done"), std::string::npos);
}

TEST(ThreadsPanel, NeedsNoLeastSize) {
  ThreadsView view{lanes_of(one_frame()), one_frame().barriers, {15, 50}, 1100, "threads", "words"};
  for (int columns = 0; columns < 70; columns += 3) {
    for (int rows = 0; rows < 14; ++rows) {
      const Canvas panel = threads_panel(view, columns, rows, Glyphs::blocks);
      EXPECT_LE(panel.columns, std::max(2, columns));
    }
  }
}

}  // namespace
}  // namespace carom::lanes_test
