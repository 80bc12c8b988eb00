// Every hard case that `carom verify` runs, as a test of its own.
//
// Each has been seen to fail.  What was broken on purpose, and which cases saw it:
//
//   event, sign of a pair's impulse       cradle rack corner three-way pi graze far collapse scaled
//                                         mirrored order dense drift ratio reversal rods gas speeds
//                                         cooling start
//   event, impulse along the velocity     graze far speeds cooling
//   event, masses of a pair swapped       pi bullet order ratio
//   event, the textbook root              graze far
//   event, contact within 1e-9            collapse scaled
//   event, at a wall within 1e-9          scaled
//   event, balls that touch never meet    cradle pi collapse
//   event, to touch a wall is to hit it   corner tight zeno pile rods
//   event, no wall as a flight begins     corner pile
//   event, sign of a joint wall's normal  corner
//   event, simultaneous hits in turn      rack three-way
//   event, flights in float               graze far collapse zeno dense reversal rods
//   event, impulses in float              rack pi graze far drift ratio reversal
//   event, impulses a unit short          corner drift reversal rods start
//   event, a partner lost, none sought    rack collapse pile mirrored order dense drift gas speeds
//                                         cooling
//   event, neighbours from half as far    collapse pile order dense drift ratio reversal rods gas
//                                         cooling
//   event, none across a periodic side    dense drift gas speeds cooling
//   event, walls as lossy as balls        zeno
//   event, sign of friction               pile (it does not come to an end)
//   event, speeds below 1e-9 are none     scaled start
//   event, an endless wait not foreseen   start
//   event, flights made again in each frame     order
//   event, going on from rounded places   order reversal
//   event, a flight's fixed ball unsaved  order
//   overlap, sign of a pair's impulse     cradle order pile scaled start (most never end)
//   overlap, no approach below 1e-9       scaled
//   overlap, impulses in float            cradle
//   overlap, walls as lossy as balls      zeno
//   overlap, sign of friction             pile
//   overlap, coincident centres' line     start
//   overlap, missed hits not counted      bullet
//   overlap, steps counted in each frame  order
//   overlap, a part of a step unsaved     order
//   overlap, a step where no time passes  start
//   both, saved numbers of 15 digits      order
//   both, coincident balls not refused    start
//   both, huge numbers not refused        start
//   a wake-up of the barrier lost         cradle bullet zeno scaled order (a thread sleeps)
//
// To resolve only the first of the walls that a ball meets at once is seen by none: the next one is
// met at the same instant, and only the counts differ.
#include <gtest/gtest.h>

#include <algorithm>

#include "carom/report.hpp"
#include "carom/verify.hpp"

namespace carom {

void PrintTo(const HardCase& each, std::ostream* out) {
  *out << each.name;
}

}  // namespace carom

namespace carom::verify_test {

namespace {

class Hard : public testing::TestWithParam<HardCase> {};

TEST_P(Hard, Case) {
  const auto results = verify({GetParam().name, 1, false}, [](const CaseResult&) {});
  for (const CaseResult& result : results) {
    if (!result.not_for.empty()) continue;
    EXPECT_TRUE(result.passed) << result.name << ", " << method_name(result.method) << ": "
                               << result.measure << ' ' << result.value << " > " << result.limit
                               << ' ' << result.failure;
  }
}

TEST(HardCases, HaveEachASceneThatSaysWhatItIsAbout) {
  for (const HardCase& each : hard_cases()) {
    EXPECT_FALSE(each.about.empty()) << each.name;
    EXPECT_EQ(hard_scene(each.name).name, each.name);
  }
  EXPECT_THROW(hard_scene("no such case"), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Verify, Hard, testing::ValuesIn(hard_cases()), [](const auto& each) {
  std::string name = each.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace carom::verify_test
