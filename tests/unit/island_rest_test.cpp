#include "solvers/event/islands/island_rest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "contact/contact_graph.hpp"
#include "contact/rest_rules.hpp"
#include "solvers/event/support.hpp"

namespace carom::event::island_rest_test {
namespace {

constexpr StepScale kStep{{0, -1}, 1, 1};

struct Island : IslandMotion {
  DisjointSets sets;
  std::vector<char> moves;

  explicit Island(std::size_t balls) : moves(balls, 0) {
    bodies.resize(balls, {{0, 0}, 0, 1});
    support.resize(balls, kStepped);
    sets.reset(balls);
  }
  /// A wall that the ball touches; degrees by which its way out is turned from upwards.
  void add_wall(int ball, double degrees, double friction) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    contacts.push_back({ball, kWall, {std::sin(angle), -std::cos(angle)}, 0, friction});
    touches.push_back(1);
  }
  void add_pair(int a, int b, const Vec<double>& normal, bool touch) {
    contacts.push_back({a, b, normal, 0, 0});
    touches.push_back(touch ? 1 : 0);
    sets.merge(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
  }
  /// Whether the first ball moves on.
  [[nodiscard]] bool moves_on() {
    hold_still(*this, kStep, sets, std::vector<char>(contacts.size(), 1), moves);
    return moves[0] != 0;
  }
};

TEST(IslandRest, ABallInAGrooveIsHeld) {
  Island groove(1);
  groove.add_wall(0, 30, 0);
  groove.add_wall(0, -50, 0);
  EXPECT_FALSE(groove.moves_on());
}

// With friction it rolls: nothing that touches it at one place keeps it from turning.
TEST(IslandRest, ABallOnASlopeMovesOnWhateverItsFriction) {
  for (const double friction : {0.0, 0.3, 3.0}) {
    Island slope(1);
    slope.add_wall(0, 30, friction);
    EXPECT_TRUE(slope.moves_on()) << friction;
  }
  Island floor(1);
  floor.add_wall(0, 0, 0);
  EXPECT_FALSE(floor.moves_on());
}

// Two walls that both push it to the right: with N1 and N2 along their ways out, and tangential
// forces that turn it neither way, it stays if N1 = N2 + 1 / (cos 30 - sin 30) and (1 + N2)
// times 1.366 is at most .366 mu N2: only for mu > 3.74.
TEST(IslandRest, ABallInAWedgeIsHeldByFrictionAtBothWalls) {
  for (const double friction : {0.0, 2.0, 3.5, 8.0}) {
    Island wedge(1);
    wedge.add_wall(0, 30, friction);
    wedge.add_wall(0, 60, friction);
    EXPECT_EQ(wedge.moves_on(), friction < 3.7) << friction;
  }
}

// Down the slope it leans on a ball that stands on the floor.
TEST(IslandRest, WhatLeansOnWhatDoesNotMoveIsHeld) {
  for (const bool other_moves : {false, true}) {
    Island pair(2);
    pair.add_wall(0, 30, 0);
    pair.add_wall(1, 0, 0);
    pair.add_wall(1, -90, 0);
    pair.contacts.push_back({0, 1, {-1, 0}, 0, 0});
    pair.touches.push_back(1);
    pair.moves[1] = other_moves ? 1 : 0;
    EXPECT_EQ(pair.moves_on(), other_moves);
    EXPECT_EQ(pair.moves[1] != 0, other_moves);
  }
}

TEST(IslandRest, OnlyAFewAreAskedAndOnlyIfSomeAreFresh) {
  Island resting(1);
  resting.support[0] = kResting;
  resting.add_wall(0, 30, 0);
  EXPECT_FALSE(resting.moves_on());
  // A row with a wall under one of them: the others fall.
  for (const std::size_t n : {kFewHeld, kFewHeld + 1}) {
    Island row(n);
    row.add_wall(0, 0, 0);
    for (int k = 1; k < static_cast<int>(n); ++k) row.add_pair(k - 1, k, {1, 0}, true);
    EXPECT_EQ(row.moves_on(), n == kFewHeld);
  }
}

// Many that stand on each other on one that lies on walls: what these cannot hold up slides with
// all that it carries.
TEST(IslandRest, ManyMoveOnWhereAllTheyLeanOnCannotHoldThemUp) {
  struct Case {
    std::vector<double> walls;  // degrees
    double friction;
    bool moves;
  };
  for (const Case& c :
       {Case{{}, 0, true}, Case{{0}, 0, false}, Case{{1e-4}, 0, true}, Case{{-1e-4}, 0, true},
        Case{{1e-6}, 0, false}, Case{{10}, 0.17, true}, Case{{10}, 0.18, false},
        Case{{-10}, 0.17, true}, Case{{30, -50}, 0, false}, Case{{30, 50}, 0, true},
        Case{{-30, -50}, 0, true}, Case{{180}, 0, true}, Case{{100, -100}, 0, true}}) {
    Island stack(kFewHeld + 1);
    for (int k = 1; k <= static_cast<int>(kFewHeld); ++k) stack.add_pair(k - 1, k, {0, 1}, true);
    for (const double degrees : c.walls) stack.add_wall(0, degrees, c.friction);
    EXPECT_EQ(stack.moves_on(), c.moves) << c.walls.size() << ' ' << c.friction;
  }
}

TEST(IslandRest, WhatComesNearerMovesWhatItTouches) {
  for (const bool nearer : {true, false}) {
    for (const bool touch : {true, false}) {
      Island row(3);
      row.contacts = {{0, 1, {1, 0}, 0, 0}, {1, 2, {1, 0}, 0, 0}};
      row.touches = {static_cast<char>(touch ? 1 : 0), 1};
      row.bodies[0].velocity = {nearer ? 1.0 : -1.0, 0};
      row.bodies[1].velocity = {0.5, 0};
      row.moves[0] = 1;
      pass_on_motion(row, row.sets, row.moves);
      const bool passed = nearer && touch;
      EXPECT_EQ(row.moves[1] != 0, passed);
      EXPECT_EQ(row.moves[2] != 0, passed);  // and the next one
    }
  }
}

TEST(IslandRest, WhatFlewOnAsBeforeWouldMeetWhatItTouches) {
  Island pair(2);
  pair.contacts = {{0, 1, {1, 0}, 0, 0}};
  pair.touches = {1};
  std::vector<ConeBody> before = pair.bodies;
  before[1].velocity = {-1, 0};  // it came to the first one, and now stands still
  EXPECT_EQ(met(pair, before), (std::vector<char>{0, 1}));
  before[1].velocity = {1, 0};
  EXPECT_EQ(met(pair, before), (std::vector<char>{0, 0}));
  before[0].velocity = {1, 0};
  EXPECT_EQ(met(pair, before), (std::vector<char>{1, 0}));
  pair.touches = {0};
  EXPECT_EQ(met(pair, before), (std::vector<char>{0, 0}));
}

}  // namespace
}  // namespace carom::event::island_rest_test
