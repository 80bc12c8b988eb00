#include "contact/sleepers.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace carom::contact::sleepers_test {
namespace {

// Balls of radius 1/2 under gravity of size 8, in steps of 1/64.  At the start of a step all but
// the last one are asleep.
struct Heap {
  explicit Heap(const std::vector<Ball>& list, const Domain& box = {{20, 20}, true})
      : domain(box), balls(list, Effects{}) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (domain.period[axis] > 0) turns[axis].assign(list.size(), 0);
    }
    rule.step = 1.0 / 64;
    rule.fall = {0, -1.0 / 1024};  // g t^2 / 2
    rule.gain = {0, -1.0 / 8};     // g t
    start.make_room(list.size(), turns);
    start.note(balls, turns, 0, list.size());
    sleepers.wake_all(balls);
    std::vector<LastingIsland::Member> members(list.size() - 1);
    for (std::uint32_t i = 0; i + 1 < list.size(); ++i) members[i].ball = i;
    sleepers.fall_asleep(members);
    sleepers.begin(0, list.size());
  }

  std::vector<std::uint32_t> woken_by(const std::vector<Pair>& near) {
    sleepers.wake_struck(balls, near);
    std::vector<std::uint32_t> woken;
    sleepers.list_woken(woken);
    return woken;
  }

  Domain domain;
  Balls balls;
  LastingRule rule;
  StepStart start;
  Turns turns;
  Sleepers sleepers{domain, rule, start, turns};
};

using Numbers = std::vector<std::uint32_t>;

TEST(Sleepers, ABallThatComesIntoOneWakesAllThatLieTogetherAndNoOthers) {
  Heap heap({Ball{{7, 0.5}}, Ball{{6, 0.5}}, Ball{{5, 0.5}}, Ball{{12, 0.5}}, Ball{{5, 1.4}}});
  EXPECT_EQ(heap.woken_by({{0, 1}, {1, 2}, {2, 4}}), (Numbers{0, 1, 2}));
  EXPECT_TRUE(heap.sleepers.asleep(3));
  EXPECT_FALSE(heap.sleepers.asleep(0));
  EXPECT_TRUE(heap.sleepers.woken(0));
  EXPECT_FALSE(heap.sleepers.woken(4));
}

TEST(Sleepers, WhatIsWokenIsWhereItWouldHaveFlown) {
  Heap heap({Ball{{5, 3}}, Ball{{5, 3.9}}});
  ASSERT_EQ(heap.woken_by({{0, 1}}), (Numbers{0}));
  EXPECT_EQ(heap.balls.at(0), (Vec2{5, 3 - 1.0 / 1024}));
  EXPECT_EQ(heap.balls.velocity[1][0], -1.0 / 8);
}

TEST(Sleepers, ABallThatIsMerelyNearWakesNone) {
  Heap heap({Ball{{5, 0.5}}, Ball{{5, 1.6}}});
  EXPECT_EQ(heap.woken_by({{0, 1}}), Numbers{});
  EXPECT_TRUE(heap.sleepers.asleep(0));
}

TEST(Sleepers, AFixedBallWakesNone) {
  Ball fixed{{5, 1.4}};
  fixed.fixed = true;
  Heap heap({Ball{{5, 0.5}}, fixed});
  EXPECT_EQ(heap.woken_by({{0, 1}}), Numbers{});
  EXPECT_TRUE(heap.sleepers.all_asleep());
}

TEST(Sleepers, AfterTheStepNothingHasJustBeenWoken) {
  Heap heap({Ball{{5, 3}}, Ball{{5, 3.9}}});
  ASSERT_EQ(heap.woken_by({{0, 1}}), (Numbers{0}));
  EXPECT_FALSE(heap.sleepers.all_asleep());
  heap.sleepers.end_step();
  heap.sleepers.begin(0, 2);
  EXPECT_EQ(heap.woken_by({{0, 1}}), Numbers{});
  EXPECT_FALSE(heap.sleepers.woken(0));
}

TEST(Sleepers, AFlightIsTakenBack) {
  Heap heap({Ball{{5, 3}}, Ball{{9, 9}}});
  heap.balls.position[1][0] = 2.9;
  heap.balls.velocity[1][0] = -1;
  heap.sleepers.put_back(heap.balls, 0);
  EXPECT_EQ(heap.balls.at(0), (Vec2{5, 3}));
  EXPECT_EQ(heap.balls.velocity[1][0], 0);
}

// Down a periodic axis, from its lower end.
struct Seam : Heap {
  Seam() : Heap({Ball{{5, 0}}, Ball{{5, 0.9}}}, Domain{box(), true}) {
    // As a flight leaves it.
    balls.position[1][0] = 20 - 1.0 / 1024;
    turns[1][0] = -1;
    sleepers.put_back(balls, 0);
  }
  static Box box() {
    Box made;
    made.width = made.height = 20;
    made.periodic = {false, true};
    return made;
  }
};

TEST(Sleepers, AFlightOverAPeriodicSideIsTakenBackWithItsTurn) {
  const Seam seam;
  EXPECT_EQ(seam.balls.at(0), (Vec2{5, 0}));
  EXPECT_EQ(seam.turns[1][0], 0);
}

TEST(Sleepers, WhatIsWokenHasTheTurnThatItWouldHaveFlown) {
  Seam seam;
  ASSERT_EQ(seam.woken_by({{0, 1}}), (Numbers{0}));
  EXPECT_EQ(seam.balls.at(0), (Vec2{5, 20 - 1.0 / 1024}));
  EXPECT_EQ(seam.turns[1][0], -1);
}

}  // namespace
}  // namespace carom::contact::sleepers_test
