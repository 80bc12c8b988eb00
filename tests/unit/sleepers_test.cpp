#include "contact/sleepers.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace carom::contact::sleepers_test {
namespace {

// Balls of radius 1/2 under gravity of size 8, in steps of 1/64.  At the start of a step all but
// the last one are asleep.
struct Heap {
  explicit Heap(const std::vector<Ball>& list) : domain({20, 20}, true), balls(list, Effects{}) {
    rule.step = 1.0 / 64;
    rule.fall = {0, -1.0 / 1024};  // g t^2 / 2
    rule.gain = {0, -1.0 / 8};     // g t
    start.make_room(list.size());
    start.note(balls, 0, list.size());
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
  Sleepers sleepers{domain, rule, start};
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

}  // namespace
}  // namespace carom::contact::sleepers_test
