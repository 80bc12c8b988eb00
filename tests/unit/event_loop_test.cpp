#include "solvers/event/event_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "solvers/event/pair_lanes.hpp"
#include "trajectory/pair_time.hpp"

namespace carom::event::event_loop_test {
namespace {

/// Every pair looked at for every impact: slow, and hard to get wrong.
template <class P>
class AllPairs {
 public:
  AllPairs(const Rules& rules, std::vector<Disk> disks)
      : motion_(rules), disks_(std::move(disks)), left_(disks_.size(), kUnknown) {}

  Counts counts;

  void advance_to(FixedTime until) {
    while (true) {
      Meeting<P> best;
      std::size_t who = 0;
      const auto offer = [&](const Meeting<P>& meeting, std::size_t i) {
        if (meeting.time < best.time) best = meeting, who = i;
      };
      for (std::size_t i = 0; i < disks_.size(); ++i) {
        if (motion_.fixed(disks_[i])) continue;
        offer(motion_.alone(disks_[i]), i);
        for (std::size_t j = 0; j < disks_.size(); ++j) {
          if (j == i || (j > i && !motion_.fixed(disks_[j]))) continue;
          const auto k = static_cast<Index>(j);
          offer({motion_.pair_event(disks_[i], disks_[j], left_[i] == k), k}, i);
        }
      }
      if (best.time > until) return;
      left_[who] = kUnknown;
      if (best.partner == kCarry) {
        motion_.carry(disks_[who], best.time);
      } else if (best.partner >= kWalls) {
        motion_.bounce(disks_[who], nullptr, best.partner, best.time);
        ++counts.ball_wall;
      } else {
        Disk& other = disks_[best.partner];
        motion_.strike(disks_[who], nullptr, other, nullptr, best.time);
        left_[best.partner] = kUnknown;
        if (motion_.fixed(other)) left_[who] = best.partner;
        ++counts.ball_ball;
      }
    }
  }

  void rebase(FixedTime by) {
    for (Disk& disk : disks_) disk.start -= by;
  }

  [[nodiscard]] const std::vector<Disk>& disks() const { return disks_; }

 private:
  Motion<P> motion_;
  std::vector<Disk> disks_;
  std::vector<Index> left_;
};

Domain domain(double width, double height, bool periodic_x, bool periodic_y) {
  Box box;
  box.width = width;
  box.height = height;
  box.periodic = {periodic_x, periodic_y};
  box.origin = Box::Origin::center;
  return {box, true};
}

std::vector<Disk> lattice(const Rules& rules, std::size_t columns, std::size_t rows) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  const Domain& d = rules.domain;
  std::vector<Disk> disks;
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      Disk disk;
      disk.x = d.lower[0] + (static_cast<double>(c) + 0.5) * (d.upper[0] - d.lower[0]) /
                                static_cast<double>(columns);
      disk.y = d.lower[1] + (static_cast<double>(r) + 0.5) * (d.upper[1] - d.lower[1]) /
                                static_cast<double>(rows);
      disk.species = static_cast<Index>((r * columns + c) % rules.all_species.size());
      if (rules.all_species[disk.species].fixed()) {
        disk.start = kEver;
      } else {
        disk.vx = normal(random);
        disk.vy = normal(random);
      }
      disks.push_back(disk);
    }
  }
  return disks;
}

template <class P = Ballistic>
void expect_same_bits(const Rules& rules, std::size_t columns, std::size_t rows, double seconds) {
  const auto start = lattice(rules, columns, rows);
  const FixedTime end = rules.scale.ticks(seconds);
  AllPairs<P> slow(rules, start);
  slow.advance_to(end);
  EventLoop<P> loop(rules);
  loop.reset(start, 0);
  loop.advance_to(end);
  ASSERT_GT(slow.counts.ball_ball, 100U);
  EXPECT_EQ(loop.counts().ball_ball, slow.counts.ball_ball);
  EXPECT_EQ(loop.counts().ball_wall, slow.counts.ball_wall);
  EXPECT_GT(loop.counts().renewals, 10U);
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Disk& a = slow.disks()[i];
    const Disk& b = loop.disks()[i];
    ASSERT_EQ(a.x, b.x) << i;
    ASSERT_EQ(a.y, b.y) << i;
    ASSERT_EQ(a.vx, b.vx) << i;
    ASSERT_EQ(a.vy, b.vy) << i;
    ASSERT_EQ(a.start, b.start) << i;
  }
}

Rules rules_of(const Domain& d) {
  return {d, FixedTimeClock((d.upper[0] - d.lower[0]) / 6), {0, 0}, true, 1, 1, {Species{}}};
}

TEST(EventLoopAlone, agrees_to_the_last_bit_with_every_pair_looked_at_between_walls) {
  expect_same_bits(rules_of(domain(12, 10, false, false)), 9, 8, 5);
}

TEST(EventLoopAlone, agrees_to_the_last_bit_with_every_pair_looked_at_on_a_torus) {
  expect_same_bits(rules_of(domain(12, 10, true, true)), 9, 8, 5);
}

TEST(EventLoopAlone, agrees_to_the_last_bit_with_every_pair_looked_at_in_a_thin_gas_in_a_channel) {
  expect_same_bits(rules_of(domain(40, 30, true, false)), 9, 8, 40);
}

TEST(EventLoopAlone,
     agrees_to_the_last_bit_with_every_pair_looked_at_for_a_mixture_with_fixed_balls) {
  Rules rules = rules_of(domain(14, 12, true, false));
  rules.all_species = {{0.5, 1}, {0.25, 8}, {0.6, 0.5}, {0.3, 0}, {0.55, 1}};
  expect_same_bits(rules, 9, 8, 5);
}

TEST(EventLoopAlone, agrees_to_the_last_bit_with_every_pair_looked_at_under_gravity) {
  Rules rules = rules_of(domain(14, 12, false, false));
  rules.gravity = {0.5, -2};
  rules.restitution = 0.95;
  expect_same_bits<Ballistic>(rules, 9, 8, 5);
}

TEST(EventLoopAlone, agrees_to_the_last_bit_with_every_pair_looked_at_falling_through_pegs) {
  Rules rules = rules_of(domain(14, 12, true, false));
  rules.gravity = {0, -2};
  rules.all_species = {{0.5, 1}, {0.25, 8}, {0.6, 0.5}, {0.3, 0}, {0.55, 1}};
  expect_same_bits<Ballistic>(rules, 9, 8, 5);
}

// Breaks where a bound is later than what it bounds: walls or squares are then left unseen.
TEST(EventLoopAlone, agrees_to_the_last_bit_with_every_pair_looked_at_under_drag) {
  Rules rules = rules_of(domain(10, 8, false, false));
  for (const double rate : {0.001, 0.2, 0.6}) {
    rules.drag_rate = rate;
    expect_same_bits<Drag>(rules, 8, 6, 8);
  }
}

TEST(EventLoopAlone, agrees_to_the_last_bit_with_every_pair_looked_at_under_gravity_and_drag) {
  Rules rules = rules_of(domain(10, 8, true, false));
  rules.gravity = {0.5, -2.25};
  rules.drag_rate = 0.2;
  expect_same_bits<Drag>(rules, 8, 6, 4);
}

TEST(EventLoopAlone, agrees_to_the_last_bit_with_every_pair_looked_at_falling_fast) {
  Rules rules = rules_of(domain(10, 8, false, false));
  rules.gravity = {0.25, -9.75};
  expect_same_bits<Ballistic>(rules, 8, 6, 8);
}

// With a tick this fine, flights are carried on several times and time is counted from 0 again many
// times.
TEST(EventLoopAlone, counting_time_from_a_later_tick_changes_no_bit) {
  Rules rules = rules_of(domain(12, 10, true, false));
  rules.scale = FixedTimeClock(0x1p-8);
  const auto start = lattice(rules, 5, 4);
  AllPairs<Ballistic> whole(rules, start);
  EventLoop<Ballistic> parts(rules);
  parts.reset(start, 0);
  constexpr FixedTime kEpoch = FixedTime{1} << 60;
  for (int epoch = 0; epoch < 40; ++epoch) {
    parts.advance_to(kEpoch);
    parts.rebase(kEpoch);
    whole.advance_to(kEpoch);
    whole.rebase(kEpoch);
  }
  ASSERT_GT(parts.counts().ball_ball, 20U);
  EXPECT_EQ(parts.counts().ball_ball, whole.counts.ball_ball);
  for (std::size_t i = 0; i < start.size(); ++i) {
    ASSERT_EQ(whole.disks()[i].x, parts.disks()[i].x);
    ASSERT_EQ(whole.disks()[i].vy, parts.disks()[i].vy);
    ASSERT_EQ(whole.disks()[i].start, parts.disks()[i].start);
  }
}

// Equal balls in a line pass each other in effect: ball i from the left is where the i-th of as
// many free points would be, between walls one diameter nearer for each ball (Jepsen 1965).
TEST(EventLoopAlone, rods_in_a_line_are_where_free_points_would_be) {
  constexpr std::size_t kRods = 12;
  Rules rules = rules_of(domain(30, 1.5, false, false));
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<Disk> rods(kRods);
  for (std::size_t i = 0; i < kRods; ++i) {
    rods[i].x = -15 + (static_cast<double>(i) + 0.5) * 30 / kRods;
    rods[i].vx = normal(random);
  }
  EventLoop<Ballistic> loop(rules);
  loop.reset(rods, 0);
  const FixedTime end = rules.scale.ticks(50);
  loop.advance_to(end);
  ASSERT_GT(loop.counts().ball_ball, 100U);

  const double low = -15 + 0.5;
  const double length = 30 - 1.0 * kRods;
  std::vector<double> points;
  for (std::size_t i = 0; i < kRods; ++i) {
    const double free = rods[i].x - static_cast<double>(i) - low + rods[i].vx * 50;
    const double folded = std::fmod(std::fmod(free, 2 * length) + 2 * length, 2 * length);
    points.push_back(folded > length ? 2 * length - folded : folded);
  }
  std::sort(points.begin(), points.end());
  for (std::size_t i = 0; i < kRods; ++i) {
    const double at = loop.motion().place(loop.disks()[i], end).x;
    EXPECT_NEAR(at, points[i] + low + static_cast<double>(i), 1e-12) << i;
  }
}

TEST(EventLoopAlone, four_pairs_at_once_have_the_bits_of_one_at_a_time) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::size_t hits = 0;
  for (int round = 0; round < 5000; ++round) {
    Lanes dx, dy, vx, vy, reach;
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      dx[l] = normal(random) * 2;
      dy[l] = normal(random) * 2;
      vx[l] = normal(random);
      vy[l] = normal(random);
      reach[l] = std::abs(normal(random));
    }
    const Lanes times = pair_times(dx, dy, vx, vy, reach);
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      const double one = pair_time(Vec<double>{dx[l], dy[l]}, Vec<double>{vx[l], vy[l]}, reach[l]);
      ASSERT_EQ(times[l], one);
      if (std::isfinite(one)) ++hits;
    }
  }
  EXPECT_GT(hits, 1000U);
}

}  // namespace
}  // namespace carom::event::event_loop_test
