#include "contact/foreseen_links.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace carom::contact::foreseen_links_test {
namespace {

// Balls of radius 1/2 as a flight has left them.
struct Flown {
  explicit Flown(const std::vector<Ball>& list) : domain({20, 20}, true), balls(list, Effects{}) {
    start.make_room(list.size(), turns);
    sleepers.wake_all(balls);
  }

  std::vector<Pair> linked(const std::vector<Pair>& near, double gap,
                           const std::vector<std::uint32_t>& out = {}) {
    std::vector<Pair> found;
    links.find(balls, near, out, gap, found);
    return found;
  }

  Domain domain;
  Balls balls;
  LastingRule rule;
  StepStart start;
  Turns turns;
  Sleepers sleepers{domain, rule, start, turns};
  ForeseenLinks links{domain, sleepers};
};

using Pairs = std::vector<Pair>;

// The first two overlap by 1/8; the gaps after them are 1/16 and 1/4.
const std::vector<Ball> kRow{Ball{{5, 9}}, Ball{{5.875, 9}}, Ball{{6.9375, 9}}, Ball{{8.1875, 9}}};
const Pairs kNear{{0, 1}, {1, 2}, {2, 3}};

TEST(ForeseenLinks, AnOverlapPushesOnOverTheGapsThatItReaches) {
  Flown row(kRow);
  EXPECT_EQ(row.linked(kNear, 0), (Pairs{{0, 1}, {1, 2}}));
  // Of the push of 1/8 there is 1/16 left.
  EXPECT_EQ(row.linked(kNear, 3.0 / 16), (Pairs{{0, 1}, {1, 2}}));
  EXPECT_EQ(row.linked(kNear, 4.0 / 16), (Pairs{{0, 1}, {1, 2}, {2, 3}}));
}

TEST(ForeseenLinks, AWallPushesToo) {
  Flown stack({Ball{{5, 0.375}}, Ball{{5, 1.4375}}});  // 1/8 beyond the floor, 1/16 apart
  EXPECT_EQ(stack.linked({{0, 1}}, 0, {0}), (Pairs{{0, 1}}));
  EXPECT_EQ(stack.linked({{0, 1}}, 0), Pairs{});
}

TEST(ForeseenLinks, WhereNothingIsPushedNothingIsLinked) {
  Flown apart({Ball{{5, 9}}, Ball{{6.0625, 9}}});
  EXPECT_EQ(apart.linked({{0, 1}}, 1), Pairs{});
}

TEST(ForeseenLinks, WhatDoesNotMovePassesNothingOn) {
  Flown row(kRow);
  row.sleepers.fall_asleep({{1}});
  EXPECT_EQ(row.linked(kNear, 0), Pairs{});
}

TEST(ForeseenLinks, NoStepRemembersThePushesOfTheOneBefore) {
  Flown row(kRow);
  ASSERT_EQ(row.linked(kNear, 0).size(), 2U);
  row.balls.position[0][0] = 4.5;
  EXPECT_EQ(row.linked(kNear, 0), Pairs{});
}

}  // namespace
}  // namespace carom::contact::foreseen_links_test
