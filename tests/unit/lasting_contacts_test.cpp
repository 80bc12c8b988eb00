#include "contact/lasting_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <vector>

namespace carom::contact::lasting_contacts_test {
namespace {

// Balls of radius 1/2 on a floor, under gravity of size 8, in steps of 1/64.
struct Floor {
  explicit Floor(const std::vector<Ball>& list)
      : effects(effects_of()), domain({20, 20}, true), balls(list, effects) {
    rule.step = 1.0 / 64;
    rule.acceleration = {0, -8};
    rule.fall = {0, -8 * rule.step * rule.step / 2};
    rule.gain = {0, -8 * rule.step};
    rule.restitution = rule.wall_restitution = 0.5;
    rule.loses = true;
    contacts.wake_all(balls);
  }

  static Effects effects_of() {
    Effects made;
    made.walls = Walls{0.5};
    made.collisions = Collisions{0.5};
    made.gravity = Gravity{{0, -8}};
    return made;
  }

  // A flight, and the islands after it.
  void fly() {
    contacts.begin(balls, 0, balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        balls.position[axis][i] += rule.step * balls.velocity[axis][i] + rule.fall[axis];
        balls.velocity[axis][i] += rule.gain[axis];
      }
    }
    std::vector<std::uint32_t> out;
    contacts.end(balls, 0, balls.size(), out);
    for (std::uint32_t i = 0; i < balls.size(); ++i) {
      for (std::uint32_t j = i + 1; j < balls.size(); ++j) {
        if ((balls.at(j) - balls.at(i)).norm() < 1.125) near.push_back({i, j});
      }
    }
    contacts.form(balls, near, out);
  }

  void resolve() {
    for (std::size_t k = 0; k < contacts.islands(); ++k) {
      contacts.resolve(k, balls, false, step, ImpactLog{});
    }
  }

  std::vector<Pair> crossing() {
    std::vector<Pair> found;
    contacts.find_crossing(balls, near, found);
    return found;
  }

  Effects effects;
  Domain domain;
  Balls balls;
  LastingRule rule;
  Turns turns;
  LastingContacts contacts{domain, rule, turns};
  IslandStep step;
  std::vector<Pair> near;
};

TEST(LastingContacts, BallsThatAreMerelyNearAreOfTwoIslands) {
  Floor apart({Ball{{5, 0.5}}, Ball{{6.05, 0.5}}});
  apart.fly();
  EXPECT_EQ(apart.contacts.islands(), 2U);
  apart.resolve();
  EXPECT_TRUE(apart.crossing().empty());
  Floor touching({Ball{{5, 0.5}}, Ball{{6, 0.5}}});
  touching.fly();
  EXPECT_EQ(touching.contacts.islands(), 1U);
}

TEST(LastingContacts, APushThatIsForeseenIsOfOneIslandAtOnce) {
  // The second ball is driven on by the first one, 1/16 in the step, over a gap of 1/64.
  Floor row({Ball{{5, 0.5}, {8, 0}}, Ball{{6.03125, 0.5}}, Ball{{7.046875, 0.5}}});
  row.fly();
  ASSERT_EQ(row.contacts.islands(), 1U);
  row.resolve();
  EXPECT_TRUE(row.crossing().empty());
  // What one pushes the other takes.
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += row.balls.velocity[0][i];
  EXPECT_NEAR(sum, 8, 1e-12);
  EXPECT_GT(row.balls.velocity[0][2], 1);
}

// Two heavy balls meet and drive one between them up by 1.7 times their own way: farther than it
// overlaps them, and into one above it.
std::vector<Ball> wedge() {
  const Vec2 up{std::sqrt(0.75), 0.5};
  Ball left{{5, 0.5}, {4, 0}};
  Ball right{{5 + 2 * up.x(), 0.5}, {-4, 0}};
  left.mass = right.mass = 1000;
  return {left, right, Ball{{5 + up.x(), 1}}, Ball{{5 + up.x(), 2.08}}};
}

TEST(LastingContacts, APushThatComesToANearBallJoinsItsIsland) {
  Floor floor(wedge());
  floor.fly();
  ASSERT_EQ(floor.contacts.islands(), 1U);
  floor.resolve();
  const std::vector<Pair> crossing = floor.crossing();
  ASSERT_EQ(crossing, (std::vector<Pair>{{2, 3}}));
  floor.contacts.join(floor.balls, floor.near, crossing, false);
  EXPECT_EQ(floor.contacts.islands(), 1U);
  floor.resolve();
  EXPECT_TRUE(floor.crossing().empty());
  EXPECT_GT(floor.balls.velocity[1][3], 1);
}

TEST(LastingContacts, JoiningLeavesOtherIslandsAsTheyAre) {
  std::vector<Ball> balls = wedge();
  balls.push_back(Ball{{12, 0.5}});
  Floor floor(balls);
  floor.fly();
  ASSERT_EQ(floor.contacts.islands(), 2U);
  floor.resolve();
  const double height = floor.balls.position[1][4];
  floor.contacts.join(floor.balls, floor.near, floor.crossing(), false);
  EXPECT_EQ(floor.contacts.islands(), 2U);
  EXPECT_EQ(floor.balls.position[1][4], height);
  EXPECT_EQ(floor.balls.velocity[1][4], 0);
}

}  // namespace
}  // namespace carom::contact::lasting_contacts_test
