#include "solvers/event/islands/island_part.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "contact/contact_graph.hpp"

namespace carom::event::island_part_test {
namespace {

/// Balls in a row, each near to the next, and the first to a wall.
struct Row : IslandMotion {
  explicit Row(int balls) {
    bodies.resize(static_cast<std::size_t>(balls), {{0, 0}, 0, 1});
    contacts.push_back({0, kWall, {-1, 0}, 0.5, 0.25});
    for (int k = 1; k < balls; ++k) contacts.push_back({k - 1, k, {1, 0}, 0, 0});
  }
};

TEST(IslandPart, WhatStandsIsAWallToWhatMoves) {
  Row row(4);
  const std::vector<char> all(row.contacts.size(), 1);
  const IslandPart part(row, {1, 0, 0, 1}, all);
  EXPECT_EQ(part.body_number, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(part.contact_number, (std::vector<std::size_t>{1, 2, 3}));
  ASSERT_EQ(part.contacts.size(), 3U);
  EXPECT_EQ(part.contacts[0].a, 0);
  EXPECT_EQ(part.contacts[0].b, kWall);
  EXPECT_EQ(part.contacts[0].normal.x, -1);  // as the ball that moves feels it
  EXPECT_EQ(part.contacts[1].b, 1);
  EXPECT_EQ(part.contacts[2].a, 1);
  EXPECT_EQ(part.contacts[2].b, kWall);
  EXPECT_EQ(part.contacts[2].normal.x, 1);
}

TEST(IslandPart, WhereNothingStandsItIsTheIslandsContactsThatLast) {
  Row row(3);
  const IslandPart part(row, {0, 0, 0}, {1, 0, 1});
  EXPECT_EQ(part.bodies.size(), 3U);
  EXPECT_EQ(part.contact_number, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(part.contacts[0].gap, 0.5);
  EXPECT_EQ(part.contacts[0].friction, 0.25);
}

TEST(IslandPart, ItsMotionIsPassedOnToItsBallsAlone) {
  Row row(3);
  IslandPart part(row, {0, 1, 0}, {1, 1, 1});
  part.bodies[0].velocity = {1, 2};
  part.bodies[1].velocity = {3, 4};
  part.pass_on(row);
  EXPECT_EQ(row.bodies[0].velocity, (Vec<double>{1, 2}));
  EXPECT_EQ(row.bodies[1].velocity, (Vec<double>{0, 0}));
  EXPECT_EQ(row.bodies[2].velocity, (Vec<double>{3, 4}));
}

TEST(IslandPart, WhatStandsFeelsWhatMovesBesideIt) {
  Row row(3);
  row.bodies[2].velocity = {0, -0.5};
  EXPECT_TRUE(reaches_standing(row, {1, 1, 0}, 0.25));
  EXPECT_FALSE(reaches_standing(row, {1, 1, 0}, 0.5));
  EXPECT_FALSE(reaches_standing(row, {1, 0, 0}, 0.25));
  row.bodies[2] = {{0, 0}, 0.5, 1};
  EXPECT_TRUE(reaches_standing(row, {1, 1, 0}, 0.25));
}

TEST(IslandPart, MotionSpreadsAlongNearBalls) {
  const Row row(6);
  std::vector<char> moves{0, 0, 1, 0, 0, 0};
  spread_motion(row, 0, moves);
  EXPECT_EQ(moves, (std::vector<char>{0, 0, 1, 0, 0, 0}));
  spread_motion(row, 2, moves);
  EXPECT_EQ(moves, (std::vector<char>{1, 1, 1, 1, 1, 0}));
}

}  // namespace
}  // namespace carom::event::island_part_test
