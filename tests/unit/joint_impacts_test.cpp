#include "solvers/event/joint_impacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "solvers/event/physics.hpp"
#include "support/flight_at.hpp"

namespace carom::event::joint_impacts_test {
namespace {

using Group = SimultaneousImpact<double>;

Rules box_rules(double friction) {
  Box box;
  box.width = 20;
  box.height = 20;
  box.origin = Box::Origin::center;
  Rules rules{{box, true}, FixedTimeClock(0.5)};
  rules.all_species = {{0.5, 1}, {0.5, 0}};
  rules.friction = friction;
  rules.spins = friction > 0;
  return rules;
}

constexpr FixedTime kNow = 1000;

/// Balls of diameter 1, all of them one group.
struct Joint {
  Motion<Ballistic> motion;
  HugeVector<Disk> disks;
  std::vector<double> spins;
  std::vector<Index> left;
  JointImpacts<Ballistic> impacts{motion, {disks, spins, left}};
  Group group;

  explicit Joint(double friction = 0) : motion(box_rules(friction)) {}

  void add(double x, double y, double vx, double vy, bool fixed = false) {
    disks.push_back(flight_at(x, y, vx, vy, fixed ? 1 : 0));
    if (fixed) disks.back().start = kEver;
    group.members.push_back(static_cast<Index>(disks.size() - 1));
    group.places.push_back({x, y});
    group.bodies.push_back({{vx, vy}, fixed ? 0.0 : 1.0});
    if (motion.rules().spins) {
      spins.push_back(0);
      group.spins.push_back(0);
    }
  }
  void touch(int a, int b, double restitution) {
    const auto place = [this](int k) { return group.places[static_cast<std::size_t>(k)]; };
    group.contacts.push_back({a, b, place(b) - place(a), restitution});
  }
  JointImpacts<Ballistic>::Outcome run() {
    auto outcome = impacts.resolve(group, nullptr, false);
    impacts.begin_flights(group, outcome.changed, kNow);
    return outcome;
  }
};

// What comes in at the one end of a row goes out at the other; those between fly on as before.
TEST(JointImpacts, OnlyWhatMovesOtherwiseBeginsAFlight) {
  Joint row;
  for (int k = 0; k < 4; ++k) row.add(k, 0, k == 0 ? 3 : 0, 0);
  for (int k = 1; k < 4; ++k) row.touch(k - 1, k, 1);
  EXPECT_EQ(row.run().changed, (std::vector<char>{1, 0, 0, 1}));
  EXPECT_EQ(row.disks[0].vx, 0);
  EXPECT_EQ(row.disks[3].vx, 3);
  EXPECT_EQ(row.disks[0].start, kNow);
  EXPECT_EQ(row.disks[1].start, 0);
  EXPECT_EQ(row.disks[3].start, kNow);
}

TEST(JointImpacts, WhatMeetsAWallIsPutThereAndWhatIsOnlyNearIsNot) {
  for (const bool meets : {true, false}) {
    Joint corner;
    const double x = -9.5 + 0x1p-30;
    corner.add(x, 0, -1, 0);
    corner.add(x + 1, 0, -2, 0);
    corner.touch(1, 0, 1);
    corner.group.contacts.push_back({0, kWall, {-1, 0}, 1});
    corner.group.stops.push_back({0, kWalls, meets});
    EXPECT_EQ(corner.run().changed[0], 1);
    EXPECT_GT(corner.disks[0].vx, 0);
    EXPECT_EQ(corner.disks[0].x, meets ? -9.5 : x);
  }
}

// A flight that begins at two fixed balls began at the left one; nothing else keeps what it left.
TEST(JointImpacts, TheFixedBallThatIsFirstByPlaceIsTheOneLeft) {
  for (const bool other_order : {false, true}) {
    Joint groove;
    groove.left.assign(4, 3);
    groove.add(0, 0, 0, -1);
    groove.add(other_order ? 0.6 : -0.6, -0.8, 0, 0, true);
    groove.add(other_order ? -0.6 : 0.6, -0.8, 0, 0, true);
    groove.add(0, 1, 0, -3);
    groove.touch(0, 1, 1);
    groove.touch(0, 2, 1);
    groove.touch(3, 0, 1);
    groove.run();
    EXPECT_EQ(groove.disks[1].start, kEver);
    EXPECT_EQ(groove.left[0], other_order ? 2U : 1U);
    EXPECT_EQ(groove.left[3], kUnknown);
  }
}

// A disk that slips past another at u turns both: with much friction it sticks, which takes a third
// of the slip's momentum: m u / 6 of each, and 2 (m u / 6) / (m r) = 2 u / 3 of spin, r = 1/2.
TEST(JointImpacts, FrictionTurnsWhatSlips) {
  Joint pair(8);
  pair.add(0, 0, 1, 0.6);
  pair.add(1, 0, -1, 0);
  pair.touch(0, 1, 1);
  EXPECT_EQ(pair.run().changed, (std::vector<char>{1, 1}));
  EXPECT_NEAR(pair.disks[0].vy, 0.6 - 0.6 / 6, 1e-12);
  EXPECT_NEAR(pair.disks[1].vy, 0.6 / 6, 1e-12);
  EXPECT_NEAR(pair.disks[0].vx, -1, 1e-12);
  EXPECT_NEAR(pair.spins[0], pair.spins[1], 1e-12);
  EXPECT_NEAR(std::abs(pair.spins[0]), 2 * 0.6 / 3, 1e-12);
}

TEST(JointImpacts, ThoseThatDoNotPartStayTogether) {
  for (const double restitution : {0.0, 0.5}) {
    Joint pair;
    pair.add(0, 0, 1, 0);
    pair.add(1, 0, 0, 0);
    pair.add(-1, 0, 1, 0);
    pair.touch(0, 1, restitution);
    pair.touch(2, 0, restitution);
    pair.run();
    EXPECT_EQ(pair.impacts.staying_together(pair.group, kNow), restitution == 0 ? 2U : 0U);
    EXPECT_EQ(pair.impacts.staying_together(pair.group, kNow + 1), 0U);
  }
}

}  // namespace
}  // namespace carom::event::joint_impacts_test
