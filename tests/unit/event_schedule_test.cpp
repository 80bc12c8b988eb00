#include "solvers/event/event_schedule.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

#include "solvers/event/event_queue_body.hpp"

namespace carom::event::event_schedule_test {
namespace {

Rules rules() {
  Box box;
  box.width = 10;
  box.height = 10;
  Rules rules{{box, true}, FixedTimeClock(0.5)};
  rules.all_species = {{0.5, 1}, {0.5, 0}};
  return rules;
}

struct ScheduleOfEvents : ::testing::Test {
  static constexpr Index kBalls = 20;
  static constexpr Index kFixed = kBalls;
  Motion<Ballistic> motion{rules()};
  HugeVector<Disk> disks = HugeVector<Disk>(kBalls + 1);
  EventSchedule<Ballistic> schedule{motion, disks};

  ScheduleOfEvents() {
    disks[kFixed].species = 1;
    for (Index i = 0; i < kBalls; ++i) disks[i].vx = 1;
    schedule.reset(0, 100);
  }

  const EventSchedule<Ballistic>::Entry* first(FixedTime until) {
    return schedule.first(until, [](auto, auto, auto) {});
  }
};

TEST_F(ScheduleOfEvents, KeepsAMeetingWithBothBalls) {
  schedule.link(1, {7, 2});
  EXPECT_EQ(disks[1].partner, 2U);
  EXPECT_EQ(disks[2].partner, 1U);
  EXPECT_EQ(disks[2].meets, 7);
  schedule.link(3, {5, kFixed});
  schedule.link(4, {5, kFixed});
  EXPECT_EQ(disks[3].partner, kFixed);
  EXPECT_EQ(disks[4].partner, kFixed);
  EXPECT_EQ(disks[kFixed].partner, kUnknown);
  schedule.link(1, {3, kUnknown});  // nothing: it keeps what it has
  EXPECT_EQ(disks[1].partner, 2U);
}

// 2 is taken from 1, which is looked at again when they would have met.
TEST_F(ScheduleOfEvents, ABallWhosePartnerIsTakenIsDueAtTheTimeTheyWouldHaveMet) {
  schedule.link(1, {7, 2});
  schedule.link(2, {5, 3});
  EXPECT_EQ(disks[1].partner, kUnknown);
  EXPECT_EQ(disks[1].meets, 7);
  EXPECT_EQ(disks[2].partner, 3U);
  const auto* entry = first(10);
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->time, 7);
  EXPECT_EQ(entry->ball, 1U);
}

TEST_F(ScheduleOfEvents, ForgetsWhatIsKnownOfABall) {
  schedule.link(1, {7, kWalls});
  schedule.forget(1);
  EXPECT_EQ(disks[1].meets, kNever);
  EXPECT_EQ(disks[1].partner, kUnknown);
}

// Held against the least of all times that are known, at random.
TEST_F(ScheduleOfEvents, GivesWhatIsDueInTheOrderOfTime) {
  std::mt19937 random(9);
  const auto below = [&random](unsigned n) { return static_cast<Index>(random() % n); };
  FixedTime now = 0;
  int given = 0;
  for (int round = 0; round < 3000; ++round) {
    const Index i = below(kBalls);
    Index partner = below(kBalls + 1);
    if (partner == i) partner = kWalls;
    const FixedTime at = now + 1 + (static_cast<FixedTime>(below(1000)) << 40);
    schedule.link(i, {at, partner});
    schedule.add(i);
    if (partner < kBalls) schedule.add(partner);
    for (Index k = 0; k < kBalls; ++k) {
      const Index other = disks[k].partner;
      if (other >= kBalls) continue;
      ASSERT_EQ(disks[other].partner, k);
      ASSERT_EQ(disks[other].meets, disks[k].meets);
    }
    if (round % 2 == 0) continue;
    FixedTime least = kNever;
    for (Index k = 0; k < kBalls; ++k) least = std::min(least, disks[k].due());
    const auto* entry = first(now + (FixedTime{1} << 50));
    if (entry == nullptr) {
      EXPECT_GT(least, now + (FixedTime{1} << 50));
      continue;
    }
    ++given;
    ASSERT_EQ(entry->time, least);
    ASSERT_EQ(disks[entry->ball].due(), least);
    const Index k = entry->ball;
    now = entry->time;
    schedule.drop_first();
    const Index other = disks[k].partner;
    schedule.forget(k);
    if (other < kBalls) schedule.forget(other);
    if (round % 500 == 499) {
      schedule.rebase(now);
      now = 0;
    }
  }
  EXPECT_GT(given, 1000);
}

}  // namespace
}  // namespace carom::event::event_schedule_test
