#include "carom/timeline.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "carom/crew.hpp"
#include "unit/watchdog.hpp"

namespace carom::timeline_test {
namespace {

using test::Watchdog;

constexpr std::int64_t kMillisecond = 1000000;

void sleep_milliseconds(int n) {
  std::this_thread::sleep_for(std::chrono::milliseconds(n));
}

/// Two phases, each of `steps` turns a frame; worker 0 is `late` milliseconds late in the second.
std::vector<Phase> two_phases(int steps, int late = 0) {
  auto turn = std::make_shared<int>(0);
  return {{"wall_computation", [](Share) {}, [] { return std::size_t{1}; }},
          {"pair_computation",
           [late](Share share) {
             if (share.index == 0 && late > 0) sleep_milliseconds(late);
           },
           [turn, steps] { return ++*turn % steps == 0 ? Phase::kFrameDone : std::size_t{0}; }}};
}

/// The barriers that a worker met, as their first letters: d w p f.
std::string met(const Timeline& timeline, std::size_t worker) {
  std::string letters;
  for (const TimelineEntry& entry : timeline.workers.at(worker)) {
    letters += timeline.barriers.at(entry.phase).front();
  }
  return letters;
}

TEST(Timeline, ThereIsNoneWhereNobodyAskedForIt) {
  Crew crew(2, two_phases(1));
  crew.do_frame();
  const Timeline timeline = crew.timeline();
  EXPECT_TRUE(timeline.control.empty());
  EXPECT_TRUE(timeline.workers.empty());
}

TEST(Timeline, EveryWorkerMeetsTheBarriersInTheirOrder) {
  const Watchdog watchdog;
  Crew crew(3, two_phases(2));
  crew.record_timeline(10);
  for (int frame = 0; frame < 3; ++frame) crew.do_frame();
  const Timeline timeline = crew.timeline();
  EXPECT_EQ(timeline.barriers, (std::vector<std::string>{"do_frame", "wall_computation",
                                                         "pair_computation", "frame_done"}));
  ASSERT_EQ(timeline.control.size(), 3U);
  ASSERT_EQ(timeline.workers.size(), 3U);
  // How long it waited for the first frame is not known.
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(met(timeline, k), "wpwpfdwpwpfdwpwpf");
}

TEST(Timeline, AThreadDoesOneThingAtATimeAndAFrameIsWithinItsOrder) {
  const Watchdog watchdog;
  Crew crew(4, two_phases(3));
  crew.record_timeline(50);
  for (int frame = 0; frame < 20; ++frame) crew.do_frame();
  const Timeline timeline = crew.timeline();
  std::int64_t before = 0;
  for (const TimelineEntry& entry : timeline.control) {
    EXPECT_LE(before, entry.begin);
    EXPECT_LE(entry.begin, entry.arrived);
    EXPECT_LE(entry.arrived, entry.left);
    before = entry.left;
  }
  for (const auto& entries : timeline.workers) {
    before = 0;
    for (const TimelineEntry& entry : entries) {
      EXPECT_LE(before, entry.begin);
      EXPECT_LE(entry.begin, entry.arrived);
      EXPECT_LE(entry.arrived, entry.left);
      before = entry.left;
      // It computes only while the control thread waits for the frame.
      if (entry.phase == 0 || entry.phase == 3) continue;
      const TimelineEntry& frame = timeline.control.at(entry.frame);
      EXPECT_GE(entry.begin, frame.begin);
      EXPECT_LE(entry.arrived, frame.left);
    }
  }
}

// Worker 0 sleeps: it computes for that long, the other waits for it.
TEST(Timeline, TellsComputingFromWaiting) {
  const Watchdog watchdog;
  Crew crew(2, two_phases(1, 30));
  crew.record_timeline(10);
  crew.do_frame();
  const Timeline timeline = crew.timeline();
  const TimelineEntry& slow = timeline.workers.at(0).at(1);
  const TimelineEntry& quick = timeline.workers.at(1).at(1);
  EXPECT_GE(slow.arrived - slow.begin, 30 * kMillisecond);
  EXPECT_GE(quick.left, slow.arrived);
  EXPECT_LE(quick.begin, slow.arrived);
}

TEST(Timeline, KeepsTheLastFrames) {
  const Watchdog watchdog;
  Crew crew(2, two_phases(100));  // more entries than there is room for at first
  crew.record_timeline(5);
  for (int frame = 0; frame < 40; ++frame) crew.do_frame();
  const auto expect_last = [&](std::size_t frames) {
    const Timeline timeline = crew.timeline(frames);
    ASSERT_EQ(timeline.control.size(), frames);
    EXPECT_EQ(timeline.control.front().frame, 40 - frames);
    for (const auto& entries : timeline.workers) {
      EXPECT_EQ(entries.size(), frames * (2 * 100 + 2));
      EXPECT_EQ(entries.front().frame, 40 - frames);
      EXPECT_EQ(entries.back().frame, 39U);
    }
  };
  expect_last(5);
  expect_last(1);
  EXPECT_EQ(crew.timeline().control.size(), 5U);
}

TEST(Timeline, WhatDoesNotFindRoomIsMissingByWholeFrames) {
  const Watchdog watchdog;
  Crew crew(1, two_phases(300));  // the first frame alone is longer than the ring at first
  crew.record_timeline(3);
  crew.do_frame();
  EXPECT_TRUE(crew.timeline().control.empty());
  crew.do_frame();
  const Timeline timeline = crew.timeline();
  ASSERT_EQ(timeline.control.size(), 1U);
  EXPECT_EQ(timeline.workers.at(0).size(), 602U);
}

TEST(Timeline, WorkersComeAndGoWhileItIsRecorded) {
  const Watchdog watchdog;
  Crew crew(2, two_phases(1));
  crew.record_timeline(100);
  crew.do_frame();
  crew.resize(4);
  crew.do_frame();
  crew.resize(1);
  crew.do_frame();
  const Timeline timeline = crew.timeline();
  ASSERT_EQ(timeline.workers.size(), 4U);
  EXPECT_EQ(timeline.workers.at(3).size(), 3U);  // its one frame; how long it waited is not known
  EXPECT_EQ(timeline.workers.at(0).back().frame, 2U);
}

TEST(Timeline, RecordingIsSwitchedOffAndOnBetweenFrames) {
  const Watchdog watchdog;
  Crew crew(3, two_phases(1));
  for (int round = 0; round < 200; ++round) {
    crew.record_timeline(round % 2 == 0 ? 4 : 0);
    crew.do_frame();
    EXPECT_EQ(crew.timeline().control.size(), round % 2 == 0 ? 1U : 0U);
  }
}

}  // namespace
}  // namespace carom::timeline_test
