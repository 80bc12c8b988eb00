#include "solvers/event/impact_lines.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace carom::event::impact_lines_test {
namespace {

/// Of balls a and a + 1.
Impact contact(std::size_t a, Vec2 normal = {1, 0}) {
  Impact line;
  line.a = a;
  line.b = a + 1;
  line.normal = normal;
  return line;
}

// A ball of mass 2 comes at (3, 1), and leaves at (-1, 4): by what the normal and t = (0, 1) take,
// b gains 2 (3 + 1) along n and 2 (1 - 4) along t.
TEST(ImpactLines, OfASingleImpactHaveTheMomentumThatBGains) {
  SingleImpact impact;
  impact.change = {4, -3};
  impact.inverse_mass = 0.5;
  impact.friction = true;
  impact.lost = 7;
  const Impact line = single_line(contact(1), impact);
  EXPECT_EQ(line.impulse, 8);
  EXPECT_EQ(line.tangential, -6);
  EXPECT_EQ(line.energy_lost, 7);
  EXPECT_EQ(line.kind, ImpactKind::ball);
  EXPECT_EQ(line.b, 2U);
}

// From the other ball, which loses what b gains, and gains what it loses.
TEST(ImpactLines, OfASingleImpactAreTheSameSeenFromEitherBall) {
  for (const Vec2 normal : {Vec2{1, 0}, Vec2{0, 1}, Vec2{0.6, -0.8}}) {
    SingleImpact of_a;
    of_a.change = {4, -3};
    of_a.inverse_mass = 0.5;
    of_a.friction = true;
    SingleImpact of_b = of_a;
    of_b.from_a = false;
    of_b.change = {-16, 12};  // of a mass of 1/2: the same momentum
    of_b.inverse_mass = 2;
    const Impact one = single_line(contact(1, normal), of_a);
    const Impact other = single_line(contact(1, normal), of_b);
    EXPECT_DOUBLE_EQ(one.impulse, other.impulse);
    EXPECT_DOUBLE_EQ(one.tangential, other.tangential);
  }
}

TEST(ImpactLines, HaveNothingTangentialWithoutFriction) {
  SingleImpact impact;
  impact.change = {4, -3};
  impact.inverse_mass = 1;
  EXPECT_EQ(single_line(contact(1), impact).tangential, 0);
}

// Two contacts, the second of which is hit twice and has friction: one line for each push, in the
// order of the contacts, friction with the first of them.
TEST(ImpactLines, OfAJointImpactAreOneForEachPush) {
  const std::vector<Impact> contacts{contact(1), contact(2)};
  JointCarried carried;
  carried.pushes = {{1, 5, 0.5}, {0, 3, 0.25}, {1, 2, 0.125}};
  carried.by_friction = {{0, 0}, {-1, 4}};
  carried.held = 100;  // only told where nothing else takes energy
  const std::vector<Impact> lines = joint_lines(contacts, carried, 9);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].a, 1U);
  EXPECT_EQ(lines[0].impulse, 3);
  EXPECT_EQ(lines[0].energy_lost, 0.25);
  EXPECT_EQ(lines[1].a, 2U);
  EXPECT_EQ(lines[1].impulse, 5);
  EXPECT_EQ(lines[1].tangential, -1);
  EXPECT_EQ(lines[1].energy_lost, 4.5);
  EXPECT_EQ(lines[2].impulse, 2);
  EXPECT_EQ(lines[2].tangential, 0);
  EXPECT_EQ(lines[2].energy_lost, 0.125);
  for (const Impact& line : lines) {
    EXPECT_EQ(line.kind, ImpactKind::joint);
    EXPECT_EQ(line.event, 9U);
  }
}

TEST(ImpactLines, OfAContactThatOnlyRubsAreOfOneAtRest) {
  const std::vector<Impact> contacts{contact(1)};
  JointCarried carried;
  carried.by_friction = {{-1, 4}};
  const std::vector<Impact> lines = joint_lines(contacts, carried, 9);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].kind, ImpactKind::rest);
  EXPECT_EQ(lines[0].tangential, -1);
  EXPECT_EQ(lines[0].energy_lost, 4);
}

TEST(ImpactLines, OfAnElasticJointImpactTellOnceWhatIsHeld) {
  const std::vector<Impact> contacts{contact(1), contact(2)};
  JointCarried carried;
  carried.elastic = true;
  carried.held = 6;
  carried.pushes = {{0, 1, 0}, {1, 1, 0}};
  const std::vector<Impact> lines = joint_lines(contacts, carried, 1);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].energy_lost, 6);
  EXPECT_EQ(lines[1].energy_lost, 0);
}

TEST(ImpactLines, OfAnIslandAreOfWhatPressesOrCounts) {
  const std::vector<Impact> contacts{contact(1), contact(2), contact(3), contact(4)};
  IslandCarried carried{{0, 2, 0, 3}, {0, 1, 1, 0}, 5};
  const std::vector<Impact> lines = island_lines(contacts, carried, 7);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].a, 2U);
  EXPECT_EQ(lines[0].kind, ImpactKind::joint);
  EXPECT_EQ(lines[0].event, 7U);
  EXPECT_EQ(lines[0].energy_lost, 5);
  EXPECT_EQ(lines[1].a, 3U);
  EXPECT_EQ(lines[1].event, 7U);
  EXPECT_EQ(lines[2].kind, ImpactKind::rest);
  EXPECT_EQ(lines[2].event, 0U);
  EXPECT_EQ(lines[2].impulse, 3);
  EXPECT_EQ(lines[2].energy_lost, 0);
}

TEST(ImpactLines, OfAnIslandWithOneImpactAreNoJointOne) {
  const std::vector<Impact> contacts{contact(1), contact(2)};
  const std::vector<Impact> lines = island_lines(contacts, {{1, 0}, {1, 0}, 0}, 7);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].kind, ImpactKind::ball);
  EXPECT_EQ(lines[0].event, 0U);
}

TEST(ImpactLines, OfAnIslandTellALossEvenWhereNothingPresses) {
  const std::vector<Impact> contacts{contact(1), contact(2)};
  const std::vector<Impact> lines = island_lines(contacts, {{0, 0}, {0, 0}, 5}, 7);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].a, 2U);
  EXPECT_EQ(lines[0].energy_lost, 5);
  EXPECT_TRUE(island_lines(contacts, {{0, 0}, {0, 0}, 0}, 7).empty());
}

}  // namespace
}  // namespace carom::event::impact_lines_test
