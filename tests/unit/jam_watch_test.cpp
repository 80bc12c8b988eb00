#include "solvers/event/jam_watch.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "contact/rest_rules.hpp"
#include "solvers/event/fixed_time.hpp"

namespace carom::event::jam_watch_test {
namespace {

constexpr double kGap = kTouching;

void widen(JamLevel& level, int times) {
  for (int k = 0; k < times; ++k) level.widen();
}

void end_spans(JamLevel& level, int spans) {
  for (int k = 0; k < spans; ++k) level.end_span();
}

TEST(JamLevel, DoublesTheGapEachTimeUntilItGivesUp) {
  JamLevel level;
  EXPECT_FALSE(level.jammed());
  double gap = kGap;
  for (int k = 1; k <= kMostDoublings; ++k, gap *= 2) {
    level.widen();
    EXPECT_TRUE(level.jammed());
    EXPECT_EQ(level.gap(), gap) << k;
    EXPECT_FALSE(level.gives_up()) << k;
  }
  level.widen();
  EXPECT_TRUE(level.gives_up());
  EXPECT_EQ(level.gap(), gap);
  level.widen();
  EXPECT_EQ(level.gap(), gap);  // no wider than that
}

TEST(JamLevel, IsOverAfterOneSpanAndBeginsAgainAtItsLastGap) {
  JamLevel level;
  widen(level, 3);
  level.end_span();
  EXPECT_FALSE(level.jammed());
  level.widen();
  EXPECT_EQ(level.gap(), 4 * kGap);
}

// Spans for which a jam lasts, if each begins as soon as the last one was over: 1, 2, 4, .. 64, 64.
TEST(JamLevel, LastsTwiceAsLongEachTimeItBeginsAgainAtOnce) {
  JamLevel level;
  for (int lasts = 1, round = 0; round < 9;
       ++round, lasts = lasts < kLongestJam ? 2 * lasts : lasts) {
    level.widen();
    end_spans(level, lasts - 1);
    EXPECT_TRUE(level.jammed()) << lasts;
    level.end_span();
    EXPECT_FALSE(level.jammed()) << lasts;
  }
}

TEST(JamLevel, LastsForOneSpanAgainAfterTwoWithoutAJam) {
  JamLevel level;
  level.widen();
  level.end_span();
  level.widen();
  end_spans(level, 2);
  ASSERT_FALSE(level.jammed());
  end_spans(level, 2);
  level.widen();
  level.end_span();
  EXPECT_FALSE(level.jammed());
}

TEST(JamLevel, GivesUpForOneSpanOnly) {
  JamLevel level;
  level.widen();
  level.end_span();
  widen(level, kMostDoublings + 1);  // it lasts for two spans
  ASSERT_TRUE(level.gives_up());
  level.end_span();
  EXPECT_TRUE(level.jammed());
  EXPECT_FALSE(level.gives_up());
}

TEST(JamLevel, RefusesImpactsThatHaveNoEnd) {
  JamLevel level;
  widen(level, kMostJams);
  EXPECT_THROW(level.widen(), std::runtime_error);
}

using Watch = JamWatch<FixedTimeClock>;

/// How many impacts, `apart` ticks from each other, are too many; 0: `most` are not.
std::uint64_t too_many(Watch& watch, FixedTime from, FixedTime apart, std::uint64_t most) {
  FixedTime now = from;
  for (std::uint64_t k = 1; k <= most; ++k, now += apart) {
    if (k == 1 || apart > 0) watch.begin_instant(now);
    if (watch.note_impact()) return k;
  }
  return 0;
}

TEST(JamWatch, TakesImpactsOfOneInstantForAJamFromAThousandOn) {
  Watch watch;
  watch.reset(0, 3, false);
  EXPECT_EQ(too_many(watch, 5, 0, 5000), 1301U);
  EXPECT_TRUE(watch.level().jammed());
  EXPECT_EQ(too_many(watch, 6, 0, 5000), 1301U);  // counted again from 0
}

TEST(JamWatch, CountsTheImpactsOfASpan) {
  Watch elastic;
  elastic.reset(0, 3, true);
  EXPECT_EQ(too_many(elastic, 1, 1, 1000), 305U);
  EXPECT_EQ(too_many(elastic, 400, 1, 1000), 305U);  // counted again from 0
  Watch lossy;
  lossy.reset(0, 3, false);
  EXPECT_EQ(too_many(lossy, 1, 1, 2000000), 1003001U);
}

TEST(JamWatch, SeesNoJamWhereTimeGoesOn) {
  Watch watch;
  watch.reset(0, 3, true);
  const FixedTime span = FixedTime{1} << (FixedTimeClock::kBits - kElasticSpan);
  EXPECT_EQ(too_many(watch, 1, span / 300, 5000), 0U);
  EXPECT_EQ(too_many(watch, 6000 * (span / 300), span / 310, 5000), 305U);
}

TEST(JamWatch, EndsAJamWithTheSpan) {
  Watch watch;
  watch.reset(0, 3, false);
  ASSERT_NE(too_many(watch, 1, 0, 5000), 0U);
  watch.begin_instant(kShortTicks);
  EXPECT_TRUE(watch.level().jammed());
  watch.begin_instant(kShortTicks + 1);
  EXPECT_FALSE(watch.level().jammed());
}

TEST(JamWatch, GoesOnFromASaveAsIfThereWereNone) {
  Watch watch;
  watch.reset(0, 3, true);
  ASSERT_NE(too_many(watch, 10, 1, 5000), 0U);
  ASSERT_NE(too_many(watch, 400, 1, 5000), 0U);
  ASSERT_EQ(too_many(watch, 800, 1, 300), 0U);
  SavedJam jam;
  watch.save(jam);
  Watch onwards;
  onwards.reset(1100, 3, true);
  onwards.restore(jam);
  EXPECT_EQ(onwards.level().gap(), watch.level().gap());
  EXPECT_EQ(too_many(onwards, 1101, 1, 300), 5U);
  EXPECT_EQ(too_many(watch, 1101, 1, 300), 5U);
  EXPECT_EQ(onwards.level().gap(), 4 * kGap);
  // One that was counted from later on counts from the present at the latest.
  jam.since = "5000";
  onwards.reset(1100, 3, true);
  onwards.restore(jam);
  const FixedTime span = FixedTime{1} << (FixedTimeClock::kBits - kElasticSpan);
  onwards.begin_instant(1101 + span);
  EXPECT_EQ(too_many(onwards, 1102 + span, 1, 304), 0U);
}

TEST(JamWatch, CountsOnWhereTimeIsCountedFromLaterOn) {
  const FixedTime by = FixedTime{1} << 40;
  Watch watch;
  watch.reset(by, 3, true);
  EXPECT_EQ(too_many(watch, by + 1, 1, 300), 0U);
  watch.rebase(by);
  EXPECT_EQ(too_many(watch, 301, 1, 300), 5U);

  Watch lossy;
  lossy.reset(by, 3, false);
  ASSERT_NE(too_many(lossy, by, 0, 5000), 0U);
  lossy.rebase(by);
  lossy.begin_instant(kShortTicks);
  EXPECT_TRUE(lossy.level().jammed());
  lossy.begin_instant(kShortTicks + 1);
  EXPECT_FALSE(lossy.level().jammed());
}

}  // namespace
}  // namespace carom::event::jam_watch_test
