#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "solvers/event/event_loop.hpp"

namespace carom::event::event_friction_test {
namespace {

struct Spinning : Disk {
  double spin = 0;
};

Rules table(double width, double height, double friction) {
  Box box;
  box.width = width;
  box.height = height;
  box.origin = Box::Origin::center;
  Rules rules{Domain(box, true), FixedTimeClock(0.5)};
  rules.friction = friction;
  rules.wall_friction = friction;
  rules.spins = true;
  return rules;
}

std::unique_ptr<EventLoop<Ballistic>> loop_of(const Rules& rules,
                                              const std::vector<Spinning>& balls) {
  auto loop = std::make_unique<EventLoop<Ballistic>>(rules);
  std::vector<double> spins;
  for (const Spinning& ball : balls) spins.push_back(ball.spin);
  loop->reset(std::vector<Disk>(balls.begin(), balls.end()), 0, {}, spins);
  return loop;
}

Spinning ball(const EventLoop<Ballistic>& loop, std::size_t i) {
  return {loop.disks()[i], loop.spins()[i]};
}

Spinning at(double x, double y, double vx = 0, double vy = 0, double spin = 0) {
  Spinning disk;
  disk.x = x;
  disk.y = y;
  disk.vx = vx;
  disk.vy = vy;
  disk.spin = spin;
  return disk;
}

/// Of uniform disks of mass 1 and radius 1/2.
double energy(const std::vector<Spinning>& disks) {
  double sum = 0;
  for (const Spinning& disk : disks) {
    sum += (disk.vx * disk.vx + disk.vy * disk.vy) / 2 + disk.spin * disk.spin / 16;
  }
  return sum;
}

// The impulse that stops the slip takes a third of it from the velocity and two thirds by the spin.
TEST(EventFriction, a_ball_thrown_along_a_wall_that_grips_leaves_it_rolling_at_two_thirds) {
  for (const double side : {-1.0, 1.0}) {
    const auto loop = loop_of(table(40, 10, 10), {at(-15, 0, 3, 2 * side)});
    loop->advance_to(loop->motion().rules().scale.ticks(3));
    const Spinning after = ball(*loop, 0);
    EXPECT_NEAR(after.vx, 2, 1e-15);
    EXPECT_EQ(after.vy, -2 * side);
    EXPECT_NEAR(after.spin * 0.5, 2 * side, 1e-15) << "no slip: the rim stands where it touches";
  }
}

TEST(EventFriction, a_wall_that_grips_little_takes_what_coulomb_allows) {
  const auto loop = loop_of(table(40, 10, 0.1), {at(-15, 0, 3, -2)});
  loop->advance_to(loop->motion().rules().scale.ticks(3));
  const Spinning after = ball(*loop, 0);
  EXPECT_NEAR(after.vx, 3 - 0.1 * 2 * 2, 1e-15);
  EXPECT_NEAR(after.spin, -2 * 0.1 * 2 * 2 / 0.5, 1e-14);
}

TEST(EventFriction, a_spinning_ball_that_hits_another_head_on_throws_it_aside) {
  const auto loop = loop_of(table(40, 10, 10), {at(-5, 0, 1, 0, 6), at(0, 0)});
  loop->advance_to(loop->motion().rules().scale.ticks(6));
  const Spinning a = ball(*loop, 0);
  const Spinning b = ball(*loop, 1);
  // slip -(r w) = -3, impulse -slip / 6 along t = (0, 1)
  EXPECT_NEAR(b.vy, 0.5, 1e-15);
  EXPECT_NEAR(a.vy, -0.5, 1e-15);
  EXPECT_NEAR(a.spin, 6 - 2 * 0.5 / 0.5, 1e-14);
  EXPECT_NEAR(b.spin, -2 * 0.5 / 0.5, 1e-14);
  EXPECT_NEAR(b.vx, 1, 1e-15);
}

// Fifteen balls in a touching triangle, struck on its axis: all impacts of the first instant are
// resolved together.
TEST(EventFriction, a_struck_rack_that_rubs_stays_its_own_mirror_image_to_the_last_bit) {
  std::vector<Spinning> disks{at(-6, 0, 10)};
  std::vector<std::size_t> twin{0};
  for (int row = 0; row < 5; ++row) {
    const std::size_t first = disks.size();
    for (int k = 0; k <= row; ++k) disks.push_back(at(row * std::sqrt(0.75), k - row / 2.0));
    for (int k = 0; k <= row; ++k) twin.push_back(first + static_cast<std::size_t>(row - k));
  }
  for (std::size_t i = 1; i < disks.size(); ++i) {
    disks[i].spin = disks[i].y == 0 ? 0 : (disks[i].y > 0 ? 3 : -3);
  }
  const auto loop = loop_of(table(20, 10, 0.4), disks);
  double last = energy(disks);
  for (int frame = 1; frame <= 200; ++frame) {
    loop->advance_to(loop->motion().rules().scale.ticks(0.05 * frame));
    std::vector<Spinning> now_there;
    for (std::size_t i = 0; i < disks.size(); ++i) now_there.push_back(ball(*loop, i));
    for (std::size_t i = 0; i < disks.size(); ++i) {
      const Spinning& a = now_there[i];
      const Spinning& b = now_there[twin[i]];
      ASSERT_EQ(a.x, b.x) << "frame " << frame << " ball " << i;
      ASSERT_EQ(a.y, -b.y) << "frame " << frame << " ball " << i;
      ASSERT_EQ(a.vx, b.vx) << "frame " << frame << " ball " << i;
      ASSERT_EQ(a.vy, -b.vy) << "frame " << frame << " ball " << i;
      ASSERT_EQ(a.spin, -b.spin) << "frame " << frame << " ball " << i;
    }
    const double now = energy(now_there);
    ASSERT_LE(now, last * (1 + 1e-14)) << "friction adds no energy; frame " << frame;
    last = now;
  }
  EXPECT_GT(loop->counts().ball_ball, 50U);
  EXPECT_LT(last, 0.9 * energy(disks));
}

}  // namespace
}  // namespace carom::event::event_friction_test
