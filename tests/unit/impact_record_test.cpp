#include "impact_record.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "carom/simulation.hpp"

namespace carom::impact_record_test {
namespace {

Impact impact(double time, std::size_t a, std::size_t b, std::uint64_t joint = 0) {
  return {.event = joint, .time = time, .a = a, .b = b};
}

/// As "event:a-b" each.
std::string listed(const std::vector<Impact>& impacts) {
  std::string text;
  for (const Impact& each : impacts) {
    text += std::to_string(each.event) + ':' + std::to_string(each.a) + '-' +
            (each.b == Impact::kNoBall ? "" : std::to_string(each.b)) + ' ';
  }
  return text;
}

const std::vector<std::size_t> kSame{0, 1, 2, 3, 4, 5};

TEST(ImpactRecord, IsInTheOrderOfTimeThenOfTheBalls) {
  ImpactRecord record;
  record.add({impact(2, 0, 1), impact(1, 2, 3), impact(1, 0, 4), impact(1, 0, 2)}, kSame);
  EXPECT_EQ(listed(record.take()), "0:0-2 1:0-4 2:2-3 3:0-1 ");
}

TEST(ImpactRecord, WhatHappensTogetherSharesANumber) {
  ImpactRecord record;
  record.add({impact(1, 4, 5), impact(1, 2, 3, 7), impact(1, 0, 1), impact(1, 1, 2, 7),
              impact(2, 0, 1, 8)},
             kSame);
  EXPECT_EQ(listed(record.take()), "0:0-1 1:1-2 1:2-3 2:4-5 3:0-1 ");
  record.add({impact(3, 0, 1, 7)}, kSame);  // a new call: another one
  EXPECT_EQ(listed(record.take()), "4:0-1 ");
}

TEST(ImpactRecord, NamesBallsByTheNumbersTheyKeep) {
  ImpactRecord record;
  record.add({impact(1, 0, 1)}, {3, 5});
  EXPECT_EQ(listed(record.take()), "0:3-5 ");
}

TEST(ImpactRecord, ACommandIsNotBeforeWhatHasHappened) {
  ImpactRecord record;
  record.add({impact(1.0000001, 0, 1)}, kSame);
  record.add({.time = 1, .kind = ImpactKind::add, .a = 6});
  const std::vector<Impact> taken = record.take();
  EXPECT_EQ(taken.at(1).time, 1.0000001);
  EXPECT_EQ(taken.at(1).event, 1U);
}

Scene three_balls() {
  Scene scene;
  scene.box.width = 10;
  scene.box.height = 10;
  scene.solver.method = Method::event;
  for (const double x : {2.0, 5.0, 8.0}) {
    Ball ball;
    ball.position = {x, 5};
    scene.balls.push_back(ball);
  }
  return scene;
}

TEST(ImpactRecord, ABallKeepsItsNumber) {
  Simulation simulation(three_balls());
  simulation.record_impacts(true);
  simulation.apply(command::Remove{1});
  Ball ball;
  ball.position = {5, 2};
  simulation.apply(command::Add{ball});
  EXPECT_EQ(simulation.ids(), (std::vector<std::size_t>{0, 2, 3}));
  simulation.apply(command::Remove{});
  EXPECT_EQ(simulation.ids(), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(listed(simulation.take_impacts()), "0:1- 1:3- 2:3- ");
}

TEST(ImpactRecord, NothingIsNotedUnlessAskedFor) {
  Simulation simulation(three_balls());
  simulation.apply(command::Remove{1});
  EXPECT_TRUE(simulation.take_impacts().empty());
}

}  // namespace
}  // namespace carom::impact_record_test
