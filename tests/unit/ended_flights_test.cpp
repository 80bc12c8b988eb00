#include "solvers/event/ended_flights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "numbers/exact_sum.hpp"
#include "solvers/event/flights_before.hpp"
#include "solvers/event/physics.hpp"

namespace carom::event::ended_flights_test {
namespace {

Rules box(bool periodic) {
  Box box;
  box.width = 10;
  box.height = 10;
  box.periodic = {false, periodic};
  return {{box, true}, FixedTimeClock(0.5)};
}

double sum(const EnergyBook& book) {
  ExactSum<double> all;
  for (const double part : book.parts()) all.add(part);
  return all.rounded();
}

Disk disk(double vx, double vy) {
  Disk disk;
  disk.x = disk.y = 5;
  disk.vx = vx;
  disk.vy = vy;
  return disk;
}

struct WithDrag : ::testing::Test {
  static constexpr double kRate = 0.5;
  Rules rules = box(false);
  std::vector<Disk> disks{disk(3, 4)};
  EnergyBook book;
  FixedTime second = rules.scale.ticks(1);

  WithDrag() { rules.drag_rate = kRate; }
};

// v fades as exp(-k t): of 25/2 the part 1 - exp(-2 k t) is lost.
TEST_F(WithDrag, AFlightThatEndsHasLostWhatDragTakes) {
  const Motion<Drag> motion(rules);
  EndedFlights<Drag> ended(motion, book);
  ended.reset(disks, {});
  ASSERT_TRUE(ended.any());
  Disk next = disk(1, 0);
  next.start = second;
  ended.end(0, next, nullptr, second);
  const double lost = 12.5 * (1 - std::exp(-2 * kRate));
  EXPECT_NEAR(sum(book), lost, 1e-14);
  // The next one, of energy 1/2, from its own start on.
  Disk last = disk(0, 0);
  last.start = 3 * second;
  ended.end(0, last, nullptr, 3 * second);
  EXPECT_NEAR(sum(book), lost + 0.5 * (1 - std::exp(-4 * kRate)), 1e-14);
}

// An end that is taken back counts for nothing.
TEST_F(WithDrag, AFlightThatGoesOnAfterAllCountsOnce) {
  const Motion<Drag> motion(rules);
  EndedFlights<Drag> ended(motion, book);
  ended.reset(disks, {});
  Disk next = disk(1, 0);
  next.start = second;
  ended.end(0, next, nullptr, second);
  ended.end(0, disks[0], nullptr, second);
  EXPECT_NEAR(sum(book), 0, 1e-14);
  Disk last = disk(0, 0);
  last.start = 2 * second;
  ended.end(0, last, nullptr, 2 * second);
  EXPECT_NEAR(sum(book), 12.5 * (1 - std::exp(-4 * kRate)), 1e-14);
}

TEST_F(WithDrag, CountsOnWhereTimeIsCountedFromLaterOn) {
  const Motion<Drag> motion(rules);
  EndedFlights<Drag> ended(motion, book);
  ended.reset(disks, {});
  ended.rebase(second);
  Disk next = disk(0, 0);
  next.start = second;
  ended.end(0, next, nullptr, second);
  EXPECT_NEAR(sum(book), 12.5 * (1 - std::exp(-4 * kRate)), 1e-14);
}

TEST(EndedFlights, CountNothingWhereNothingIsLost) {
  const Motion<Ballistic> motion(box(true));
  EnergyBook book;
  EndedFlights<Ballistic> ended(motion, book);
  ended.reset(std::vector<Disk>{disk(1, 1)}, {});
  EXPECT_FALSE(ended.any());
  EXPECT_TRUE(ended.turns()[0].empty());
  EXPECT_TRUE(ended.turns()[1].empty());
}

// A ball that falls through the bottom of a box of height 10 comes in at the top.
TEST(EndedFlights, CountTurnsRoundAnAxisThatGravityPullsAlong) {
  Rules rules = box(true);
  rules.gravity = {0, -2};
  rules.falls = true;
  const Motion<Ballistic> motion(rules);
  EnergyBook book;
  EndedFlights<Ballistic> ended(motion, book);
  ended.reset(std::vector<Disk>{disk(0, 0), disk(0, 0)}, {});
  ASSERT_TRUE(ended.any());
  const FixedTime now = rules.scale.ticks(5);  // it has fallen 25, from 5 to -20
  Disk next = disk(0, -10);
  next.y = 0;
  next.start = now;
  ended.end(1, next, nullptr, now);
  EXPECT_TRUE(ended.turns()[0].empty());
  EXPECT_EQ(ended.turns()[1], (std::vector<std::int64_t>{0, -2}));
}

TEST(FlightsBefore, GiveBackThoseThatAreAskedFor) {
  FlightsBefore<Ballistic> before;
  for (const Index i : {3U, 1U, 2U}) before.add({i, disk(i, 0), 0.5 * i, kUnknown});
  std::vector<Index> given;
  before.take_back([](Index i) { return i != 1; },
                   [&](const FlightsBefore<Ballistic>::Before& flight) {
                     given.push_back(flight.ball);
                     EXPECT_EQ(flight.disk.vx, flight.ball);
                     EXPECT_EQ(flight.spin, 0.5 * flight.ball);
                   });
  EXPECT_EQ(given, (std::vector<Index>{3, 2}));
  ASSERT_EQ(before.all().size(), 1U);
  EXPECT_EQ(before.all()[0].ball, 1U);
  before.clear();
  EXPECT_TRUE(before.all().empty());
}

TEST(FlightsBefore, BeganEarlierOnALaterClock) {
  FlightsBefore<Ballistic> before;
  Disk late = disk(1, 0);
  late.start = 100;
  Disk early = disk(1, 0);
  early.start = kEver + 10;
  before.add({0, late, 0, kUnknown});
  before.add({1, early, 0, kUnknown});
  Disk before_0 = disk(1, 0);
  before_0.start = -5;
  before.add({2, before_0, 0, kUnknown});
  before.rebase(70);
  EXPECT_EQ(before.all()[0].disk.start, 30);
  EXPECT_EQ(before.all()[1].disk.start, kEver);
  EXPECT_EQ(before.all()[2].disk.start, -75);
}

}  // namespace
}  // namespace carom::event::ended_flights_test
