#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "contact/island.hpp"
#include "support/island_equilibrium.hpp"

namespace carom::contact::contact_island_test {
namespace {

// Balls of radius 1/2 that touch, under gravity of size 1 downwards.
struct Pile {
  std::vector<IslandBody> bodies;
  std::vector<IslandContact> contacts;
  IslandStep::Rule rule{1.0 / 64, {0, -1}, 2.0 / 64, 1.0 / 64};
  double friction = 0;

  int ball(double mass = 1) {
    IslandBody body;
    body.inverse_mass = 1 / mass;
    body.free = rule.step * rule.acceleration;
    body.free_mean = body.free / 2;
    bodies.push_back(body);
    return static_cast<int>(bodies.size()) - 1;
  }
  void on_floor(int a) { contacts.push_back({a, -1, {0, -1}, 0, friction, 0.5}); }
  void touch(int a, int b, double x, double y) {
    contacts.push_back({a, b, {x, y}, 0, friction, 0.5});
  }
  bool spins() const { return friction > 0; }
  double residual() const {
    return equilibrium_residual(bodies, contacts, spins(), rule.acceleration);
  }
  bool holds() {
    IslandStep step;
    return step.holds(bodies, contacts, spins(), rule);
  }
  IslandOutcome take() {
    IslandOutcome outcome;
    IslandStep step;
    step.take(bodies, contacts, spins(), rule, outcome);
    return outcome;
  }
};

TEST(ContactIsland, ATowerOfFiftyStandsAndCarriesItsWeight) {
  Pile pile;
  for (int k = 0; k < 50; ++k) {
    pile.ball();
    k == 0 ? pile.on_floor(0) : pile.touch(k - 1, k, 0, 1);
  }
  EXPECT_LT(pile.residual(), 1e-9);
  EXPECT_TRUE(pile.holds());
  const IslandOutcome outcome = pile.take();
  EXPECT_TRUE(outcome.solved);
  for (std::size_t k = 0; k < 50; ++k) {
    EXPECT_NEAR(outcome.after[k].y(), 0, 1e-6 / 64);
    EXPECT_NEAR(outcome.normal[k] * 64, double(50 - k), 1e-4);  // what lies above it
  }
}

// What would lift the first ball out of the floor is more than the motion of the second has.
TEST(ContactIsland, AnOverlapDoesNotStopWhatHardlyMoves) {
  constexpr double kSpeed = 0x1p-20;
  Pile pile;
  for (int k = 0; k < 2; ++k) pile.on_floor(pile.ball());
  pile.contacts[0].gap = -1e-4;
  for (Vec2* v : {&pile.bodies[1].before, &pile.bodies[1].free, &pile.bodies[1].free_mean}) {
    v->x() = kSpeed;
  }
  const IslandOutcome outcome = pile.take();
  EXPECT_NEAR(outcome.mean[1].x(), kSpeed, kSpeed / 64);
  EXPECT_NEAR(outcome.after[1].x(), kSpeed, kSpeed / 64);
}

TEST(ContactIsland, AnOverlapComesApartWhereMotionPaysForIt) {
  Pile pile;
  for (int k = 0; k < 2; ++k) pile.on_floor(pile.ball());
  pile.contacts[0].gap = -1e-4;
  for (Vec2* v : {&pile.bodies[1].before, &pile.bodies[1].free, &pile.bodies[1].free_mean}) {
    v->x() = 1;
  }
  EXPECT_GT(pile.take().mean[0].y(), 0);
}

TEST(ContactIsland, ABallInTheAirIsNotInEquilibrium) {
  Pile pile;
  pile.ball();
  EXPECT_NEAR(pile.residual(), 1, 1e-12);
  EXPECT_FALSE(pile.holds());
}

// Two side by side, the third on top: it needs mu >= tan(15 degrees) at the floor and between
// balls.
TEST(ContactIsland, ATriangleStandsJustAboveItsCoefficientAndFallsJustBelow) {
  const double theory = std::tan(std::acos(-1.0) / 12);
  for (const double factor : {1.001, 0.999}) {
    Pile pile;
    pile.friction = factor * theory;
    for (int k = 0; k < 3; ++k) pile.ball();
    pile.on_floor(0);
    pile.on_floor(1);
    pile.touch(0, 2, 0.5, std::sqrt(0.75));
    pile.touch(1, 2, -0.5, std::sqrt(0.75));
    EXPECT_EQ(pile.holds(), factor > 1);
    EXPECT_EQ(pile.residual() < 1e-6, factor > 1);
  }
}

// A pyramid without friction is pushed apart; between walls it stands.
TEST(ContactIsland, APyramidOfTenRowsStandsBetweenWalls) {
  for (const bool walls : {true, false}) {
    Pile pile;
    std::vector<int> below;
    for (int row = 0; row < 10; ++row) {
      std::vector<int> here;
      for (int k = 0; k < 10 - row; ++k) {
        here.push_back(pile.ball());
        if (row == 0) pile.on_floor(here.back());
        if (k > 0) pile.touch(here[std::size_t(k) - 1], here.back(), 1, 0);
        if (row == 0) continue;
        pile.touch(below[std::size_t(k)], here.back(), 0.5, std::sqrt(0.75));
        pile.touch(below[std::size_t(k) + 1], here.back(), -0.5, std::sqrt(0.75));
      }
      if (row == 0 && walls) {
        pile.contacts.push_back({here.front(), -1, {-1, 0}, 0, 0, 0.5});
        pile.contacts.push_back({here.back(), -1, {1, 0}, 0, 0, 0.5});
      }
      below = here;
    }
    EXPECT_EQ(pile.holds(), walls);
    EXPECT_EQ(pile.residual() < 1e-6, walls);
  }
}

TEST(ContactIsland, HeavyBallsRestOnLightOnes) {
  for (const double mass : {1e3, 1e4, 1e6}) {
    Pile pile;
    for (int k = 0; k < 4; ++k) {
      pile.ball(k % 2 == 0 ? 1 : mass);
      k == 0 ? pile.on_floor(0) : pile.touch(k - 1, k, 0, 1);
    }
    EXPECT_TRUE(pile.holds()) << mass;
    const IslandOutcome outcome = pile.take();
    EXPECT_TRUE(outcome.solved) << mass;
    for (const Vec2& v : outcome.after) EXPECT_NEAR(v.y(), 0, 1e-5 / 64) << mass;
  }
}

// On a slope of angle a uniform disk rolls with 2/3 of the pull if mu >= tan(a)/3, else it slips
// with g (sin a - mu cos a).
TEST(ContactIsland, OnASlopeABallRollsOrSlipsByTheBook) {
  const double angle = 0.5;
  for (const double factor : {1.01, 0.5}) {
    Pile pile;
    pile.friction = factor * std::tan(angle) / 3;
    pile.rule.acceleration = {std::sin(angle), -std::cos(angle)};
    pile.ball();
    pile.bodies[0].before = {0.7, 0};
    pile.bodies[0].turning = -0.7;
    pile.bodies[0].free = pile.bodies[0].before + pile.rule.step * pile.rule.acceleration;
    pile.on_floor(0);
    const IslandOutcome outcome = pile.take();
    const double pull =
        factor > 1 ? 2.0 / 3 * std::sin(angle) : std::sin(angle) - pile.friction * std::cos(angle);
    EXPECT_NEAR(outcome.after[0].x(), 0.7 + pull * pile.rule.step, 1e-6 / 64);
    EXPECT_NEAR(outcome.after[0].y(), 0, 1e-6 / 64);
    EXPECT_NEAR(outcome.mean[0].x(), 0.7 + pull * pile.rule.step / 2, 1e-6 / 64);
    EXPECT_FALSE(pile.holds());
  }
}

TEST(ContactIsland, WhatIsPulledALittleIsNotHeld) {
  for (const double tilt : {1e-4, 1e-6}) {
    Pile pile;
    pile.rule.acceleration = {tilt, -1};
    pile.ball();
    pile.on_floor(0);
    pile.ball();
    pile.touch(0, 1, 0, 1);
    EXPECT_FALSE(pile.holds()) << tilt;
  }
}

TEST(ContactIsland, ASingleImpactIsTheOneOfTheBook) {
  Pile pile;
  pile.rule.acceleration = {0, 0};
  pile.ball(2);
  pile.ball(1);
  pile.bodies[0].before = pile.bodies[0].free = {3, 1};
  pile.bodies[1].before = pile.bodies[1].free = {0, -1};
  pile.touch(0, 1, 1, 0);
  const IslandOutcome outcome = pile.take();
  // J = (1 + e) v / (1/m + 1/M) = 1.5 x 3 / 1.5
  EXPECT_NEAR(outcome.after[0].x(), 1.5, 1e-6);
  EXPECT_NEAR(outcome.after[1].x(), 3, 1e-6);
  EXPECT_NEAR(outcome.after[0].y(), 1, 1e-12);
  EXPECT_EQ(outcome.bounced[0], 1);
}

TEST(ContactIsland, UnitsThatArePowersOfTwoChangeNoBit) {
  const auto make = [](double length, double mass) {
    Pile pile;
    pile.friction = 0.4;
    pile.rule = {1.0 / 64, {0.1 * length, -length}, 2 * length / 64, length / 64};
    for (int k = 0; k < 3; ++k) pile.ball(mass * (1 + k));
    pile.bodies[2].before = {0.3 * length, -2 * length};
    pile.bodies[2].free = pile.bodies[2].before + pile.rule.step * pile.rule.acceleration;
    pile.on_floor(0);
    pile.on_floor(1);
    pile.touch(0, 2, 0.5, std::sqrt(0.75));
    pile.touch(1, 2, -0.5, std::sqrt(0.75));
    return pile.take();
  };
  const IslandOutcome plain = make(1, 1);
  const IslandOutcome scaled = make(8, 0.5);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(8 * plain.after[k].x(), scaled.after[k].x());
    EXPECT_EQ(8 * plain.after[k].y(), scaled.after[k].y());
    EXPECT_EQ(8 * plain.turning[k], scaled.turning[k]);
  }
}

}  // namespace
}  // namespace carom::contact::contact_island_test
