#include "solvers/event/simultaneous_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/flight_at.hpp"
#include "support/predicted_balls.hpp"

namespace carom::event::simultaneous_choice_test {
namespace {

using Choice = SimultaneousChoice<Ballistic>;
using Way = Choice::Way;

/// Balls of diameter 1 in a box of 20 by 20 around the origin, the last of which is fixed.
struct Choosing : ::testing::Test, PredictedBalls {
  SimultaneousPairs pairs;
  JamLevel jam;
  Counts counts;
  EnergyBook book;
  ImpactNotes notes;
  Resolutions resolutions{counts, book, notes};
  Choice choice{motion, {disks, prediction}, {pairs, resolutions, ties, jam}};

  Choosing() : PredictedBalls(rules()) {}

  static Rules rules() {
    Box box;
    box.width = 20;
    box.height = 20;
    box.origin = Box::Origin::center;
    Rules rules{{box, true}, FixedTimeClock(0.5)};
    rules.all_species = {{0.5, 1}, {0.5, 0}};
    return rules;
  }
  /// A row of balls that touch, which go towards each other: the first ones faster.
  void add_row(Index balls) {
    for (Index k = 0; k < balls; ++k) disks.push_back(flight_at(k, 0, balls - 1.0 - k));
    disks.push_back(flight_at(balls, 0, 0, 0, 1));
    disks.back().start = kEver;
    neighbours.reset(disks, 0);
    pairs.reset(disks.size());
    resolutions.reset(disks.size());
  }
  void resolve(Index i) {
    resolutions.begin();
    resolutions.add(i);
    resolutions.end();
  }
};

std::vector<Pair> sorted(std::vector<Pair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST_F(Choosing, WhatSharesABallIsResolvedTogether) {
  add_row(6);
  pairs.wait(0, 1);
  pairs.wait(2, 3);
  pairs.wait(4, 3);
  const Choice::Sorted found = choice.take_waiting(0);
  EXPECT_EQ(found.alone, (std::vector<Pair>{{0, 1}}));
  EXPECT_EQ(sorted(found.together), (std::vector<Pair>{{2, 3}, {4, 3}}));
  EXPECT_TRUE(pairs.waiting().empty());
  EXPECT_FALSE(pairs.any_pressed());
}

// What several hit at one time is no reason where it never moves.
TEST_F(Choosing, AWallAndAFixedBallAreSharedByAnyNumber) {
  add_row(2);
  pairs.wait(0, kWalls);
  pairs.wait(1, kWalls);
  EXPECT_EQ(choice.take_waiting(0).alone.size(), 2U);
  pairs.wait(0, 2);
  pairs.wait(1, 2);
  EXPECT_EQ(choice.take_waiting(0).alone.size(), 2U);
  pairs.wait(0, 2);
  pairs.wait(0, kWalls);
  EXPECT_EQ(choice.take_waiting(0).together.size(), 2U);
}

// The middle one of three meets both others at once; that must have been seen.
TEST_F(Choosing, ATieIsResolvedTogether) {
  add_row(3);
  EXPECT_EQ(choice.way_of(0, 1, 0), Way::alone);
  ties.note(0, 1);
  EXPECT_EQ(choice.way_of(0, 1, 0), Way::together);
  EXPECT_EQ(choice.way_of(1, 0, 0), Way::together);
  disks[2].x += 1;  // it meets one alone
  EXPECT_EQ(choice.way_of(0, 1, 0), Way::alone);
}

TEST_F(Choosing, WhatIsTakenAsJammedIsResolvedTogether) {
  add_row(2);
  jam.widen();
  EXPECT_EQ(choice.way_of(0, 1, 0), Way::together);
}

// A ball hit before, that comes nearer to another, passes the impact on; what would change nothing
// is over.
TEST_F(Choosing, AnImpactIsPassedOnUntilNothingComesNearer) {
  add_row(3);
  resolve(0);
  EXPECT_EQ(choice.way_of(0, 1, 0), Way::together);
  EXPECT_EQ(choice.way_of(1, 0, 0), Way::together);
  EXPECT_EQ(choice.way_of(1, 2, 0), Way::alone);
  pairs.note_resolved(1, 0);
  EXPECT_EQ(choice.way_of(0, 1, 0), Way::over);
  disks[2].vx = 2;
  resolve(2);
  EXPECT_EQ(choice.way_of(1, 2, 0), Way::over);  // they go apart
  pairs.wait(1, 2);
  const Choice::Sorted found = choice.take_waiting(0);
  EXPECT_TRUE(found.alone.empty() && found.together.empty());
  EXPECT_EQ(pairs.take_pressed(), (std::vector<Pair>{{1, 2}}));
}

TEST_F(Choosing, AWallIsComeToOrLeft) {
  add_row(2);
  disks[0].x = -9.5;
  disks[0].vx = -1;
  resolve(0);
  EXPECT_EQ(choice.way_of(0, kWalls, 0), Way::together);
  disks[0].vx = 1;
  EXPECT_EQ(choice.way_of(0, kWalls, 0), Way::over);
}

TEST_F(Choosing, ManyImpactsAtOneInstantAreOver) {
  add_row(2);
  resolve(0);
  for (int k = 0; k < kManyAtOnce; ++k) pairs.count_hit(1);
  EXPECT_EQ(choice.way_of(0, 1, 0), Way::together);
  pairs.count_hit(1);
  EXPECT_EQ(choice.way_of(0, 1, 0), Way::over);
}

// A ball that was hit is between two that it comes to: both wait, whichever its event is.
TEST_F(Choosing, AllThatABallIsSentIntoWaits) {
  add_row(3);
  disks[1].vx = 5;
  disks[0].vx = 9;
  pairs.wait(1, 2);
  choice.add_all_met(0);
  EXPECT_EQ(pairs.waiting().size(), 1U);  // none of the two was hit before
  resolve(1);
  choice.add_all_met(0);
  EXPECT_EQ(sorted(pairs.waiting()), (std::vector<Pair>{{1, 0}, {1, 2}}));
  choice.add_all_met(0);
  EXPECT_EQ(pairs.waiting().size(), 2U);
}

}  // namespace
}  // namespace carom::event::simultaneous_choice_test
