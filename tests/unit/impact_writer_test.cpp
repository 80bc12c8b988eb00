#include "solvers/event/impact_writer.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "solvers/event/physics.hpp"
#include "support/flight_at.hpp"

namespace carom::event::impact_writer_test {
namespace {

/// Balls of radius 1/2 and mass 1, 2 in a box of 10 by 10.
struct Writing : ::testing::Test {
  Motion<Ballistic> motion{rules()};
  HugeVector<Disk> disks;
  ImpactLog log;
  ImpactNotes notes;
  ImpactWriter<Ballistic> writer{motion, disks, notes};

  Writing() { notes.write_to(&log); }

  static Rules rules() {
    Box box;
    box.width = 10;
    box.height = 10;
    Rules rules{{box, true}, FixedTimeClock(0.5)};
    rules.all_species = {{0.5, 1}, {0.5, 0.5}};
    return rules;
  }
  void add(double x, double y, double vx, double vy, Index species = 0) {
    disks.push_back(flight_at(x, y, vx, vy, species));
  }
  /// What the ball does from now on.
  Disk turn(Index i, double vx, double vy) {
    Disk was = disks[i];
    disks[i].vx = vx;
    disks[i].vy = vy;
    return was;
  }
};

// Masses 1 and 2 that come at 3 and 0 leave at -1 and 2: the impulse is 4, at (4, 5) along x.
TEST_F(Writing, AnImpactOfTwoIsALineWithTheirImpulse) {
  for (const bool other_first : {false, true}) {
    disks.clear();
    log.impacts.clear();
    add(4, 5, 3, 0);
    add(5, 5, 0, 0, 1);
    const Disk a = turn(0, -1, 0);
    const Disk b = turn(1, 2, 0);
    if (other_first) {
      writer.single(1, 0, b, a, 7, 0);
    } else {
      writer.single(0, 1, a, b, 7, 0);
    }
    ASSERT_EQ(log.impacts.size(), 1U);
    const Impact& line = log.impacts[0];
    EXPECT_EQ(line.kind, ImpactKind::ball);
    EXPECT_EQ(line.a, 0U);
    EXPECT_EQ(line.b, 1U);
    EXPECT_EQ(line.position, (Vec2{4, 5}));
    EXPECT_EQ(line.normal, (Vec2{1, 0}));
    EXPECT_EQ(line.distance, 1);
    EXPECT_EQ(line.impulse, 4);
    EXPECT_EQ(line.energy_lost, 7);
  }
}

TEST_F(Writing, AnImpactAtAWallNamesTheWall) {
  const std::vector<std::pair<Vec2, Side>> walls{
      {{-1, 0}, Side::left}, {{1, 0}, Side::right}, {{0, -1}, Side::bottom}, {{0, 1}, Side::top}};
  for (Index wall = 0; wall < 4; ++wall) {
    const auto& [normal, side] = walls[wall];
    disks.clear();
    log.impacts.clear();
    add(5, 5, 3 * normal.x(), 3 * normal.y(), 1);
    const Disk was = turn(0, -2 * normal.x(), -2 * normal.y());
    writer.single(0, kWalls + wall, was, {}, 0, 0);
    ASSERT_EQ(log.impacts.size(), 1U);
    EXPECT_EQ(log.impacts[0].kind, ImpactKind::wall);
    EXPECT_EQ(log.impacts[0].wall, side);
    EXPECT_EQ(log.impacts[0].normal, normal);
    EXPECT_EQ(log.impacts[0].distance, 0.5);
    EXPECT_EQ(log.impacts[0].impulse, 10);  // mass 2 times 3 + 2
    EXPECT_EQ(log.impacts[0].b, Impact::kNoBall);
  }
}

TEST_F(Writing, AJointImpactIsALineForEachOfItsContacts) {
  add(4, 5, 0, 0);
  add(5, 5, 0, 0);
  SimultaneousImpact<double> group;
  group.members = {1, 0};
  group.contacts = {{0, 1, {-1, 0}, 1}, {0, kWall, {0, -1}, 0.5}};
  group.stops = {{0, kWalls + 2, true}};
  JointRecord<double> record;
  record.strokes = {{1, 3, 2, 0.5}, {0, 4, 1, 1}};
  writer.joint(group, record, motion.rules().scale.ticks(2));
  ASSERT_EQ(log.impacts.size(), 2U);
  EXPECT_EQ(log.impacts[0].a, 0U);
  EXPECT_EQ(log.impacts[0].b, 1U);
  EXPECT_EQ(log.impacts[0].normal, (Vec2{1, 0}));  // from the lower number
  EXPECT_EQ(log.impacts[0].impulse, 4);
  EXPECT_EQ(log.impacts[0].energy_lost, 0);
  EXPECT_EQ(log.impacts[1].a, 1U);
  EXPECT_EQ(log.impacts[1].wall, Side::bottom);
  EXPECT_EQ(log.impacts[1].energy_lost, 3 * 2 * 0.5 / 2);  // J u (1 - e) / 2
  for (const Impact& line : log.impacts) {
    EXPECT_EQ(line.kind, ImpactKind::joint);
    EXPECT_EQ(line.event, 1U);
    EXPECT_EQ(line.time, 2);
  }
}

TEST_F(Writing, ABallThatWakesIsALineWhereItIs) {
  add(4, 5, 0, 0);
  writer.wake(0, 0);
  ASSERT_EQ(log.impacts.size(), 1U);
  EXPECT_EQ(log.impacts[0].kind, ImpactKind::wake);
  EXPECT_EQ(log.impacts[0].position, (Vec2{4, 5}));
}

TEST_F(Writing, SlidesAreNothingWithoutALog) {
  add(4, 5, 1, 0);
  notes.write_to(nullptr);
  writer.slides(0, disks[0], nullptr, 5);
  notes.write_to(&log);
  notes.keep_slides();
  EXPECT_TRUE(log.impacts.empty());
}

}  // namespace
}  // namespace carom::event::impact_writer_test
