// Joint impacts whose outcome is known.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/exact_number.hpp"
#include "support/joint_group.hpp"

namespace carom::event::event_contact_joint_test {
namespace {

using test::approaches;
using test::energy;
using test::Group;
using test::momentum;
using test::Rack;
using test::V;

Group cradle(int n, int striking, double e) {
  Group group;
  for (int k = 0; k < n; ++k) {
    group.bodies.push_back({{k < striking ? 0.7 : 0.0, 0}, 1 / 0.3});
    if (k > 0) group.contacts.push_back({k - 1, k, {1, 0}, e});
  }
  return group;
}

TEST(EventJointImpact, ACradlePassesExactlyAsManyBallsOnAsStrike) {
  for (int n = 2; n <= 12; ++n) {
    for (int striking = 1; striking < n; ++striking) {
      Group group = cradle(n, striking, 1);
      const auto report = group.resolve();
      for (int k = 0; k < n; ++k) {
        const double expected = k >= n - striking ? 0.7 : 0;
        EXPECT_EQ(group.bodies[static_cast<std::size_t>(k)].velocity.x, expected) << n << k;
        EXPECT_EQ(group.bodies[static_cast<std::size_t>(k)].velocity.y, 0);
      }
      EXPECT_EQ(report.impacts, striking * (n - striking));
      EXPECT_EQ(report.locked, 0);
    }
  }
}

TEST(EventJointImpact, ACradleStruckFromBothEndsSendsBothBack) {
  Group group = cradle(5, 1, 1);
  group.bodies[4].velocity.x = -0.7;
  group.resolve();
  const double expected[] = {-0.7, 0, 0, 0, 0.7};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(group.bodies[k].velocity.x, expected[k], 1e-15);
}

TEST(EventJointImpact, ACornerReversesABallExactly) {
  for (const double e : {1.0, 0.5}) {
    Group group;
    group.bodies.push_back({{0.3, 0.7}, 2});
    group.contacts = {{0, kWall, {1, 0}, e}, {0, kWall, {0, 1}, e}};
    group.resolve();
    EXPECT_EQ(group.bodies[0].velocity.x, -e * 0.3);
    EXPECT_EQ(group.bodies[0].velocity.y, -e * 0.7);
  }
}

TEST(EventJointImpact, ABallPinchedBetweenTwoHeavyOnesThrowsThemBack) {
  // two equal balls close in on a third between them: by symmetry they reverse
  Group group;
  group.bodies = {{{1, 0}, 1}, {{0, 0}, 1}, {{-1, 0}, 1}};
  group.contacts = {{0, 1, {1, 0}, 1}, {1, 2, {1, 0}, 1}};
  group.resolve();
  EXPECT_NEAR(group.bodies[0].velocity.x, -1, 1e-15);
  EXPECT_EQ(group.bodies[1].velocity.x, 0);
  EXPECT_NEAR(group.bodies[2].velocity.x, 1, 1e-15);
}

TEST(EventJointImpact, ABallInTheGapOfTwoDrivesThemApartAsTheBookSays) {
  // cue along x onto two touching balls at 30 degrees to either side: each gets 2 sqrt(3)/5 v along
  // its normal, the cue -1/5 v
  Group group;
  const double c = std::sqrt(0.75);
  group.bodies = {{{1, 0}, 1}, {{0, 0}, 1}, {{0, 0}, 1}};
  group.contacts = {{0, 1, {c, 0.5}, 1}, {0, 2, {c, -0.5}, 1}, {1, 2, {0, -1}, 1}};
  group.resolve();
  EXPECT_NEAR(group.bodies[0].velocity.x, -0.2, 4e-16);
  EXPECT_EQ(group.bodies[0].velocity.y, 0);
  EXPECT_NEAR(group.bodies[1].velocity.x, 0.6, 4e-16);
  EXPECT_NEAR(group.bodies[1].velocity.y, 2 * std::sqrt(3) / 5 / 2, 4e-16);
  EXPECT_EQ(group.bodies[2].velocity.x, group.bodies[1].velocity.x);
  EXPECT_EQ(group.bodies[2].velocity.y, -group.bodies[1].velocity.y);
}

// One after the other the wall takes 2 m v of the first ball, which gives it to the others again,
// so that all of them end at rest, after infinitely many impacts: (1 - m / M) / (1 + m / M) of the
// speed is left from one to the next.
TEST(EventJointImpact, WhatIsPressedBetweenAnElasticWallAndPlasticBallsEndsAsContact) {
  for (const int many : {1, 5, 20}) {
    for (const double heavy : {1.0, 1e3, 1e6}) {
      Group group;
      for (int k = 0; k <= many; ++k) {
        group.bodies.push_back({{-1, 0}, k == 0 ? 1 : 1 / heavy});
        group.contacts.push_back({k, k == 0 ? kWall : k - 1, {-1, 0}, k == 0 ? 1.0 : 0.0});
      }
      const auto report = group.resolve();
      EXPECT_LE(report.rounds, 100) << many << ' ' << heavy;
      for (const auto& body : group.bodies) EXPECT_NEAR(body.velocity.x, 0, 1e-13) << heavy;
      EXPECT_NEAR(report.lost, (1 + many * heavy) / 2, 1e-12 * many * heavy);
    }
  }
}

TEST(EventJointImpact, BetweenAWallAndAHeavyBallCountsThePiBilliard) {
  const int expected[] = {3, 31, 314, 3141};
  for (int k = 0; k < 4; ++k) {
    Group group;
    group.bodies = {{{0, 0}, 1}, {{-1, 0}, std::pow(100.0, -k)}};
    group.contacts = {{0, kWall, {-1, 0}, 1}, {0, 1, {1, 0}, 1}};
    const auto report = group.resolve();
    EXPECT_EQ(report.impacts + report.walls, expected[k]);
    EXPECT_EQ(report.walls, expected[k] / 2);  // in turn, the balls first
    EXPECT_NEAR(energy(group), std::pow(100.0, k) / 2, 1e-12 * std::pow(100.0, k));
  }
}

// A ball that lies in a corner and is hit: it has two impacts, with the walls, and stays.
TEST(EventJointImpact, CountsTheWallsOfACornerApart) {
  const double s = std::sqrt(0.5);
  Group group;
  group.bodies = {{{0, 0}, 1}, {{-1, -1}, 1}};
  group.contacts = {{0, kWall, {-1, 0}, 1}, {0, kWall, {0, -1}, 1}, {0, 1, {s, s}, 1}};
  const auto report = group.resolve();
  EXPECT_EQ(group.bodies[0].velocity, (V{0, 0}));
  EXPECT_EQ(group.bodies[1].velocity, (V{1, 1}));
  EXPECT_EQ(report.impacts, 2);
  EXPECT_EQ(report.walls, 2);
}

TEST(EventJointImpact, InAHundredDigitsKeepsTheRacksEnergyToAllOfThem) {
  using test::Exact;
  const Rack rack(4, 1);
  std::vector<Body<Exact>> bodies;
  std::vector<Contact<Exact>> contacts;
  for (const auto& b : rack.group.bodies) {
    bodies.push_back({{Exact(b.velocity.x), Exact(b.velocity.y)}, Exact(b.inverse_mass)});
  }
  for (const auto& c : rack.group.contacts) {
    contacts.push_back({c.a, c.b, {Exact(c.r.x), Exact(c.r.y)}, Exact(1)});
  }
  Group twin = rack.group;
  twin.resolve();
  joint_impact(std::span<Body<Exact>>(bodies), std::span<const Contact<Exact>>(contacts));
  Exact sum = 0;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const auto& v = bodies[k].velocity;
    sum += (v.x * v.x + v.y * v.y) / bodies[k].inverse_mass / 2;
    EXPECT_LE(abs(v.x - twin.bodies[k].velocity.x), 1e-14);
    EXPECT_LE(abs(v.y - twin.bodies[k].velocity.y), 1e-14);
  }
  EXPECT_LE(abs(sum - Exact(0.5)), Exact("1e-97"));
}

TEST(EventJointImpact, AnInelasticGroupMovesOnAsOne) {
  Group group = cradle(8, 1, 0);
  const auto report = group.resolve();
  EXPECT_FALSE(approaches(group));
  EXPECT_NEAR(momentum(group).x, 0.3 * 0.7, 1e-15);
  for (const auto& body : group.bodies) EXPECT_NEAR(body.velocity.x, 0.7 / 8, 1e-15);
  EXPECT_EQ(report.rounds, 1);
  EXPECT_EQ(report.impacts, 7);
  EXPECT_EQ(report.locked, 0);
}

}  // namespace
}  // namespace carom::event::event_contact_joint_test
