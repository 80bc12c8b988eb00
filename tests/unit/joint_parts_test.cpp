// The parts of a joint impact: which contacts approach, how long they are reflected, and what
// happens where reflections do not end: bodies get one velocity, or their energy back.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "contact/common_velocities.hpp"
#include "contact/group_motion.hpp"
#include "contact/jammed_contacts.hpp"
#include "contact/joint_impact.hpp"
#include "contact/kept_energy.hpp"
#include "contact/reflection_limits.hpp"
#include "contact/rounding_approaches.hpp"

namespace carom::event::joint_parts_test {
namespace {

using Bodies = std::vector<Body<double>>;
using Contacts = std::vector<Contact<double>>;
using Velocities = std::vector<Vec<double>>;

using Chosen = std::vector<char>;

constexpr double kUnit = std::numeric_limits<double>::epsilon();

TEST(GroupMotion, AsksWhichContactsApproachAndByMoreThanRounding) {
  // 1 comes to 0, slower than the rounding of what 0 has had; 2 parts from 1, and comes to a wall.
  const Bodies bodies{{{8, 0}, 1}, {{8 - 4 * kUnit, 0}, 1}, {{9, 0}, 1}, {{1, 0}, 0}};
  const Contacts contacts{
      {0, 1, {1, 0}, 1}, {1, 2, {1, 0}, 1}, {2, kWall, {1, 0}, 1}, {3, kWall, {1, 0}, 1}};
  const ContactGraph<double> graph(bodies, contacts);
  GroupMotion<double> motion(bodies, graph);
  EXPECT_EQ(motion.approaching(false), (Chosen{1, 0, 1, 0}));
  EXPECT_EQ(motion.approaching(true), (Chosen{0, 0, 1, 0}));
  EXPECT_EQ(motion.mobile(), (Chosen{1, 1, 1, 0}));
  motion.velocities()[0] = {8 - 4 * kUnit, 0};
  motion.velocities()[2] = {-1, 0};
  motion.note_peaks();
  EXPECT_EQ(motion.peak(1), 17) << "each at its fastest";
  EXPECT_EQ(motion.approaching(true), (Chosen{0, 1, 0, 0}));
  motion.velocities()[0] = {-3, 0};
  motion.velocities()[1] = {-2, 0};
  EXPECT_FALSE(motion.approaching(false));
  EXPECT_DOUBLE_EQ(motion.energy(), (9 + 4 + 1) / 2.0);
}

// A body of mass m between a wall and one of mass M makes about pi sqrt(M / m) impacts.
TEST(ReflectionLimits, LeaveEnoughRoundsForAMassAMillionTimesAsLarge) {
  const Bodies bodies{{{0, 0}, 1}, {{-1, 0}, 1e-6}};
  const Contacts contacts{{0, kWall, {-1, 0}, 1}, {0, 1, {1, 0}, 1}};
  const ContactGraph<double> graph(bodies, contacts);
  EXPECT_TRUE(is_lossless(graph));
  EXPECT_GT(most_rounds(graph), 3142);
  EXPECT_GT(most_of_wedge(graph, most_rounds(graph)), 3142);
}

constexpr int kPush = kPushes;
std::vector<int> jammed(const Bodies& bodies, const Contacts& contacts, int most) {
  const std::vector<char> found = jammed_contacts(ContactGraph<double>(bodies, contacts), most,
                                                  std::vector<char>(contacts.size(), 0));
  return {found.begin(), found.end()};
}

// Galperin: pi over the angle, whose tangent is the root of the masses' ratio.
TEST(JammedContacts, AreThoseOfAWedgeThatTakesTooManyRounds) {
  const Bodies bodies{{{0, 0}, 1}, {{-1, 0}, 1e-6}};
  const Contacts contacts{{0, kWall, {-1, 0}, 1}, {0, 1, {1, 0}, 1}};
  EXPECT_EQ(jammed(bodies, contacts, 4096), (std::vector<int>{0, 0}));
  EXPECT_EQ(jammed(bodies, contacts, 2048), (std::vector<int>{kPush, kPush}));
}

// A row fills the width; what lies on it, and the ball above that, can leave.
TEST(JammedContacts, AreThoseThatASelfStressHolds) {
  const Bodies bodies{{{0, 0}, 1}, {{0, 0}, 0.25}, {{0, 0}, 1e3}, {{0, 0}, 1}};
  const Contacts contacts{{0, kWall, {-1, 0}, 1}, {0, 1, {1, 0}, 1}, {1, kWall, {1, 0}, 0.5},
                          {0, kWall, {0, -1}, 1}, {0, 2, {0, 1}, 1}, {2, 3, {0.6, 0.8}, 1}};
  EXPECT_EQ(jammed(bodies, contacts, 4096), (std::vector<int>{kPush, kPush, kPush, 0, 0, 0}));
  // A ball between two fixed ones askew, one of which it would have to pass.
  const Bodies wedged{{{0, 0}, 1}, {{0, 0}, 0}, {{0, 0}, 0}, {{0, 0}, 0}};
  const Contacts around{{0, 1, {0, -1}, 1}, {0, 2, {0.8, 0.6}, 1}, {0, 3, {-0.8, 0.6}, 1}};
  EXPECT_EQ(jammed(wedged, around, 4096), (std::vector<int>{kPush, kPush, kPush}));
}

TEST(ReflectionLimits, KnowLossesWedgesAndWhatHasNoWayOut) {
  const Bodies one{{{1, 0}, 1}};
  const Contacts lossy{{0, kWall, {0, -1}, 0}};
  const ContactGraph<double> inelastic(one, lossy);
  EXPECT_FALSE(is_lossless(inelastic));
  EXPECT_EQ(most_rounds(inelastic), 0);
}

TEST(RoundingApproaches, AreEndedByNudgesThatAreRounding) {
  const Bodies bodies{{{3, 1}, 1}, {{3 - 4 * kUnit, 1}, 0.5}};
  const Contacts contacts{{0, 1, {0.6, 0.8}, 1}};
  const ContactGraph<double> graph(bodies, contacts);
  GroupMotion<double> motion(bodies, graph);
  ASSERT_TRUE(motion.approaching(false));
  RoundingApproaches<double> rounding(bodies, graph, motion);
  rounding.end([](const Chosen&) { FAIL() << "a nudge is enough"; });
  EXPECT_FALSE(motion.approaching(false));
  EXPECT_GT(rounding.rounds(), 0);
  EXPECT_EQ(rounding.locked(), 0);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(motion.velocities()[k].x, 3, 64 * kUnit);
    EXPECT_NEAR(motion.velocities()[k].y, 1, 64 * kUnit);
  }
}

TEST(RoundingApproaches, OfWedgedBodiesEndInACommonVelocity) {
  // Between two walls, and reflecting does not help.
  const Bodies bodies{{{1, 2}, 1}};
  const Contacts contacts{{0, kWall, {1, 0}, 1}, {0, kWall, {-1, 0}, 1}};
  const ContactGraph<double> graph(bodies, contacts);
  GroupMotion<double> motion(bodies, graph);
  RoundingApproaches<double> rounding(bodies, graph, motion);
  int reflections = 0;
  rounding.end([&](const Chosen&) {
    ++reflections;
    motion.velocities()[0].x = -motion.velocities()[0].x;
  });
  EXPECT_EQ(reflections, rounding.rounds());
  EXPECT_GT(reflections, 0);
  EXPECT_EQ(rounding.locked(), 1);
  EXPECT_EQ(motion.velocities()[0].x, 0);
  EXPECT_EQ(motion.velocities()[0].y, 2);
  EXPECT_DOUBLE_EQ(rounding.lost(), 0.5);
}

// Body 0 is wedged between a wall and two fixed balls.  Body 2 comes to it and is no part of the
// wedge: it keeps its speed along body 0.
TEST(RoundingApproaches, WhatComesToABodyThatIsStillGoesOnAlongIt) {
  const Bodies bodies{{{0.5, 0}, 1}, {{0, 0}, 0}, {{-4, 3}, 1}, {{0, 0}, 0}};
  const Contacts contacts{{0, kWall, {0, -1}, 1},
                          {0, 1, {0.6, 0.8}, 1},
                          {0, 3, {-0.6, 0.8}, 1},
                          {2, 0, {-0.8, -0.6}, 1}};
  const ContactGraph<double> graph(bodies, contacts);
  GroupMotion<double> motion(bodies, graph);
  RoundingApproaches<double> rounding(bodies, graph, motion);
  rounding.end([](const Chosen&) {});
  EXPECT_FALSE(motion.approaching(false));
  EXPECT_EQ(rounding.locked(), 1);
  EXPECT_EQ(motion.velocities()[0].x, 0);
  EXPECT_EQ(motion.velocities()[0].y, 0);
  EXPECT_NEAR(motion.velocities()[2].x, -0.6 * 4.8, 1e-12);
  EXPECT_NEAR(motion.velocities()[2].y, 0.8 * 4.8, 1e-12);
}

TEST(CommonVelocities, TellWhatIsFreeAndWhatIsStill) {
  const Bodies bodies{{{0, 0}, 1}, {{0, 0}, 0.5}, {{0, 0}, 0}};
  const Contacts contacts{
      {0, 1, {0.8, 0.6}, 1}, {1, 2, {0.6, 0.8}, 1}, {1, kWall, {1, 0}, 1}, {0, 1, {1, 0}, 1}};
  const ContactGraph<double> graph(bodies, contacts);
  CommonVelocities<double> common(bodies, graph);
  EXPECT_FALSE(common.is_beside_still(0));
  EXPECT_EQ(common.free_mobility(3), 0) << "on an axis";
  EXPECT_EQ(common.free_mobility(0), 1.5);
  EXPECT_EQ(common.free_mobility(1), 0.5) << "a fixed ball does not move";
  EXPECT_EQ(common.free_mobility(2), 0) << "a wall";
  common.join(2, 0);
  EXPECT_FALSE(common.is_beside_still(0)) << "it is joined along one axis";
  EXPECT_EQ(common.free_mobility(0), 0) << "it is not free";
  common.join(1, 0);
  EXPECT_TRUE(common.is_beside_still(0));
  EXPECT_EQ(common.free_mobility(0), 1);
}

TEST(CommonVelocities, KeepTheMomentumOfWhatIsJoined) {
  const Bodies bodies{{{4, 1}, 1}, {{0, 2}, 1.0 / 3}, {{5, 5}, 1}};
  const Contacts contacts{{0, 1, {1, 0}, 1}};
  const ContactGraph<double> graph(bodies, contacts);
  CommonVelocities<double> common(bodies, graph);
  common.join(0, 0);
  Velocities velocities{{4, 1}, {0, 2}, {5, 5}};
  common.give(velocities);
  EXPECT_EQ(common.joined(), 2);
  EXPECT_EQ(velocities[0].x, 1) << "(1 * 4 + 3 * 0) / 4";
  EXPECT_EQ(velocities[1].x, 1);
  EXPECT_EQ(velocities[0].y, 1) << "across the contact nothing changes";
  EXPECT_EQ(velocities[1].y, 2);
  EXPECT_EQ(velocities[2].x, 5) << "of no contact";
}

TEST(CommonVelocities, OfWhatIsJoinedToAWallAreNone) {
  const Bodies bodies{{{4, 1}, 1}, {{2, 2}, 1}};
  const Contacts contacts{{0, kWall, {1, 0}, 1}, {0, 1, {-1, 0}, 1}};
  const ContactGraph<double> graph(bodies, contacts);
  CommonVelocities<double> common(bodies, graph);
  common.join(0, 0);
  common.join(1, 0);
  Velocities velocities{{4, 1}, {2, 2}};
  common.give(velocities);
  EXPECT_EQ(velocities[0].x, 0);
  EXPECT_EQ(velocities[1].x, 0);
  EXPECT_EQ(velocities[0].y, 1);
}

TEST(KeptEnergy, ScalesTheMotionAboutTheCentreOfMass) {
  const Bodies bodies{{{3, 0}, 1}, {{1, 0}, 1}};
  const Contacts contacts{{0, 1, {1, 0}, 1}};
  const ContactGraph<double> graph(bodies, contacts);
  const Velocities start{{3, 0}, {1, 0}};
  Velocities velocities{{1.5, 0}, {2.5, 0}};  // about 2, a half where it was 1
  EXPECT_EQ(KeptEnergy<double>(bodies, graph).give_back(start, velocities), 0);
  EXPECT_EQ(velocities[0].x, 1);
  EXPECT_EQ(velocities[1].x, 3);
}

TEST(KeptEnergy, SendsBackWhatCanMoveNowhereOrHoldsItsEnergy) {
  const Bodies bodies{{{2, 0}, 1}};
  const Contacts wall{{0, kWall, {1, 0}, 1}};
  const ContactGraph<double> at_one_wall(bodies, wall);
  const Velocities start{{2, 0}};
  Velocities velocities{{0, 0}};
  EXPECT_EQ(KeptEnergy<double>(bodies, at_one_wall).give_back(start, velocities), 0);
  EXPECT_EQ(velocities[0].x, -2);
  const Contacts walls{{0, kWall, {1, 0}, 1}, {0, kWall, {-1, 0}, 1}};
  const ContactGraph<double> between(bodies, walls);
  velocities = {{0, 0}};
  EXPECT_EQ(KeptEnergy<double>(bodies, between).give_back(start, velocities), 2) << "m v^2 / 2";
  EXPECT_EQ(velocities[0].x, 0);
}

// Two fixed balls are in its way, and stopping it would take both: so it goes back as it came. What
// reflections end is not stopped, though its impacts have had no end before.
TEST(JointImpact, StopsOnlyWhatReflectionsDoNotEnd) {
  Bodies bodies{{{0.25, 2}, 1}, {{0, 0}, 0}, {{0, 0}, 0}};
  const Contacts wedge{{0, 1, {-0.6, 0.8}, 1}, {0, 2, {0.6, 0.8}, 1}};
  const JointReport report = joint_impact<double>(bodies, wedge, true);
  EXPECT_EQ(report.jammed, 0);
  EXPECT_EQ(report.held_energy, 0);
  EXPECT_NEAR(bodies[0].velocity.x, -0.25, 16 * kUnit);
  EXPECT_NEAR(bodies[0].velocity.y, -2, 16 * kUnit);
}

// The way back is closed to a billionth of the motion only, or to most of it.
TEST(KeptEnergy, SendsBackAsFarAsTheWayIsOpen) {
  const Bodies bodies{{{0, 0}, 1}};
  const Contacts corner{{0, kWall, {0, 1}, 1}, {0, kWall, {-1, 0}, 1}};
  const ContactGraph<double> graph(bodies, corner);
  for (const double across : {1e-9, 20.0}) {
    const Velocities start{{across, 2}};
    const double speed = std::hypot(across, 2);
    for (const bool goes_back : {true, false}) {
      Velocities velocities{{0, 0}};
      const double held = KeptEnergy<double>(bodies, graph).give_back(start, velocities, goes_back);
      EXPECT_DOUBLE_EQ(held, goes_back ? 0 : speed * speed / 2);
      EXPECT_EQ(velocities[0].x, 0);
      EXPECT_DOUBLE_EQ(velocities[0].y, goes_back ? -speed : 0);
    }
  }
}

}  // namespace
}  // namespace carom::event::joint_parts_test
