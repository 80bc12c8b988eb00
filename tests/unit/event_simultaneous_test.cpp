#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "solvers/event/event_loop.hpp"
#include "support/flight_at.hpp"

namespace carom::event::event_simultaneous_test {
namespace {

Rules table(double width, double height) {
  Box box;
  box.width = width;
  box.height = height;
  box.origin = Box::Origin::center;
  return {Domain(box, true), FixedTimeClock(0.5), {0, 0}, true, 1, 1, {Species{}}};
}

TEST(EventSimultaneous, a_cradle_passes_on_as_many_balls_as_come_in) {
  for (int coming = 1; coming <= 4; ++coming) {
    std::vector<Disk> disks;
    disks.reserve(5);
    for (int k = 0; k < 5; ++k) {
      disks.push_back(k < coming ? flight_at(k - 4.0, 0, 1) : flight_at(k - 3.0, 0));
    }
    EventLoop<Ballistic> loop(table(40, 10));
    loop.reset(disks, 0);
    loop.advance_to(loop.motion().rules().scale.ticks(3));
    for (int k = 0; k < 5; ++k) {
      EXPECT_EQ(loop.disks()[static_cast<std::size_t>(k)].vx, k >= 5 - coming ? 1 : 0) << k;
      EXPECT_EQ(loop.disks()[static_cast<std::size_t>(k)].vy, 0);
    }
  }
}

TEST(EventSimultaneous, a_hit_into_an_exact_corner_reverses_exactly) {
  EventLoop<Ballistic> loop(table(8, 8));
  loop.reset({flight_at(0, 0, 3, 3)}, 0);
  loop.advance_to(loop.motion().rules().scale.ticks(1.5));
  EXPECT_EQ(loop.disks()[0].vx, -3);
  EXPECT_EQ(loop.disks()[0].vy, -3);
  EXPECT_EQ(loop.disks()[0].x, 3.5);
  EXPECT_EQ(loop.disks()[0].y, 3.5);
  EXPECT_EQ(loop.counts().ball_wall, 2U);
}

TEST(EventSimultaneous, two_balls_that_hit_a_third_at_once_leave_as_mirror_images) {
  for (const bool swapped : {false, true}) {
    std::vector<Disk> disks{flight_at(-2, 0.75, 1), flight_at(-2, -0.75, 1), flight_at(0.3, 0)};
    if (swapped) std::swap(disks[0], disks[1]);
    EventLoop<Ballistic> loop(table(40, 10));
    loop.reset(disks, 0);
    loop.advance_to(loop.motion().rules().scale.ticks(3));
    const Disk& upper = loop.disks()[swapped ? 1 : 0];
    const Disk& lower = loop.disks()[swapped ? 0 : 1];
    const Disk& third = loop.disks()[2];
    EXPECT_EQ(upper.vx, lower.vx);
    EXPECT_EQ(upper.vy, -lower.vy);
    EXPECT_GT(upper.vy, 0);
    EXPECT_EQ(third.vy, 0);
    EXPECT_GT(third.vx, 0);
    EXPECT_NEAR(upper.vx + lower.vx + third.vx, 2, 1e-15);
  }
}

// Fifteen balls in a touching triangle, struck on its axis.
TEST(EventSimultaneous, a_struck_rack_stays_its_own_mirror_image_to_the_last_bit) {
  std::vector<Disk> disks{flight_at(-6, 0, 10)};
  std::vector<std::size_t> twin{0};
  for (int row = 0; row < 5; ++row) {
    const std::size_t first = disks.size();
    for (int k = 0; k <= row; ++k) disks.push_back(flight_at(row * std::sqrt(0.75), k - row / 2.0));
    for (int k = 0; k <= row; ++k) twin.push_back(first + static_cast<std::size_t>(row - k));
  }
  EventLoop<Ballistic> loop(table(20, 10));
  loop.reset(disks, 0);
  std::size_t compared = 0;
  for (int frame = 1; frame <= 400; ++frame) {
    loop.advance_to(loop.motion().rules().scale.ticks(0.05 * frame));
    for (std::size_t i = 0; i < disks.size(); ++i) {
      const Disk& a = loop.disks()[i];
      const Disk& b = loop.disks()[twin[i]];
      ASSERT_EQ(a.x, b.x) << "frame " << frame << " ball " << i;
      ASSERT_EQ(a.y, -b.y) << "frame " << frame << " ball " << i;
      ASSERT_EQ(a.vx, b.vx) << "frame " << frame << " ball " << i;
      ASSERT_EQ(a.vy, -b.vy) << "frame " << frame << " ball " << i;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 400U * 16U);
  EXPECT_GT(loop.counts().ball_ball, 100U);
  double energy = 0;
  for (const Disk& disk : loop.disks()) energy += disk.vx * disk.vx + disk.vy * disk.vy;
  EXPECT_NEAR(energy, 100, 1e-11);
}

}  // namespace
}  // namespace carom::event::event_simultaneous_test
