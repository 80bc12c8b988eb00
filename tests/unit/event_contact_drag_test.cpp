#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "solvers/event/flight_lanes.hpp"
#include "trajectory/damped_law.hpp"

namespace carom::event::event_contact_drag_test {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;

/// dx/dt = v, dv/dt = a - rate v, as the textbooks have it.
Exact textbook_place(double x, double v, double a, double rate, const Exact& t) {
  const Exact end = Exact(a) / rate;
  return x + end * t + (v - end) * (1 - exp(Exact(-rate * t))) / rate;
}

class Drag : public testing::Test {
 protected:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  /// Over many powers of ten.
  double size() { return std::pow(10, between(-6, 2)); }
  double either(double a) { return between(-1, 1) < 0 ? -a : a; }

  std::mt19937_64 random_{2};
};

TEST_F(Drag, a_flight_goes_where_the_textbook_has_it_for_rates_of_any_size) {
  for (int k = 0; k < 2000; ++k) {
    const double rate = size();
    const double t = size();
    const DampedLaw<double> law{{either(size()), 0}, rate};
    const Flight<double> flight{{0, 0}, {either(size()), 1}};
    const Exact x = textbook_place(0, flight.velocity.x, law.gravity.x, rate, t);
    const Exact y = textbook_place(0, 1, 0, rate, t);
    const Vec<double> moved = law.displacement(flight, t);
    const double scale = std::abs(flight.velocity.x) * t + std::abs(law.gravity.x) * t * t;
    const double whole =
        std::min(scale, std::abs(flight.velocity.x) / rate + std::abs(law.gravity.x) / rate * t);
    EXPECT_NEAR(static_cast<double>(Exact(moved.x) - x), 0, 0x1p-50 * whole);
    EXPECT_NEAR(static_cast<double>(Exact(moved.y) / y - 1), 0, 0x1p-50);
    const Exact remaining = exp(Exact(-rate) * t);
    EXPECT_NEAR(static_cast<double>(law.velocity(flight, t).y - remaining), 0, 0x1p-51);
  }
}

TEST_F(Drag, without_a_rate_a_flight_is_the_ballistic_one) {
  for (int k = 0; k < 1000; ++k) {
    const Vec<double> g{either(size()), either(size())};
    const Flight<double> flight{{0, 0}, {either(size()), either(size())}};
    const double t = size();
    const Vec<double> a = DampedLaw<double>{g, 0}.displacement(flight, t);
    const Vec<double> b = BallisticLaw<double>{g}.displacement(flight, t);
    const double scale = std::abs(flight.velocity.x) * t + std::abs(g.x) * t * t;
    EXPECT_NEAR(a.x, b.x, 0x1p-51 * scale);
    EXPECT_EQ(time_of_way(t, 0.0), t);
  }
}

// The textbook's height at the time found is zero to what rounding the time makes of it, and before
// that it has no other sign.
TEST_F(Drag, a_wall_is_met_when_the_textbook_says_and_not_before) {
  int hits = 0;
  int misses = 0;
  for (int k = 0; k < 500; ++k) {
    const double h = k % 4 == 0 ? 0 : size();
    const double v = h == 0 ? size() : either(size());
    const double a = k % 5 == 0 && h != 0 ? 0 : (h == 0 ? -size() : either(size()));
    const double rate = size();
    const double t = damped_wall_time(h, v, a, rate);
    const bool hit = t < never<double>();
    (hit ? hits : misses) += 1;
    const double until = hit ? t : 1e3 / rate;
    for (int n = 1; n < 40; ++n) {
      const Exact part = Exact(until) * n / 40;
      ASSERT_GT(textbook_place(h, v, a, rate, part), -1e-15 * h) << h << ' ' << v << ' ' << a;
    }
    if (!hit) continue;
    const Exact end = textbook_place(h, v, a, rate, t);
    const Exact slope = a / Exact(rate) + (v - a / Exact(rate)) * exp(Exact(-rate) * t);
    const double allowed = 16 * 0x1p-53 * std::abs(static_cast<double>(slope)) * t +
                           8 * 0x1p-53 * (h + std::abs(v) * std::min(t, 1 / rate));
    ASSERT_NEAR(static_cast<double>(end), 0, allowed) << h << ' ' << v << ' ' << a << ' ' << rate;
  }
  EXPECT_GT(hits, 200);
  EXPECT_GT(misses, 30);
}

// Looked at in small steps nothing is found that the method has not found, but for gaps as small as
// what a step passes over.
TEST_F(Drag, a_fixed_ball_is_met_when_small_steps_say) {
  int hits = 0;
  int misses = 0;
  for (int k = 0; k < 2000; ++k) {
    const double rate = std::pow(10, between(-3, 1));
    const double angle = between(0, 6.28);
    const double away = k % 3 == 0 ? 1 : between(1.01, 5);
    const Vec<double> r{away * std::cos(angle), away * std::sin(angle)};
    const Vec<double> g{k % 2 == 0 ? 0 : between(-2, 2), between(-4, 4)};
    Vec<double> v{between(-3, 3), between(-3, 3)};
    const bool from_contact = k % 3 == 0;
    if (from_contact && dot(r, v) <= 0) v = -v;
    if (from_contact && dot(r, v) <= 0) continue;
    const double t = damped_fixed_disk_time(r, v, g, 1.0, rate, from_contact);
    const DampedLaw<double> law{g, rate};
    const auto gap = [&](double at) {
      const Vec<double> p = r + law.displacement({r, v}, at);
      return p.x * p.x + p.y * p.y - 1;
    };
    const bool hit = t < never<double>();
    (hit ? hits : misses) += 1;
    const double until = hit ? t : 30;
    constexpr int kSteps = 1500;
    for (int n = 1; n < kSteps; ++n) {
      const double at = until * n / kSteps;
      ASSERT_GT(gap(at), -1e-11) << "case " << k << " at " << at << " of " << t;
    }
    if (hit) {
      ASSERT_NEAR(gap(t), 0, 1e-12 * (1 + t * t)) << "case " << k;
    }
  }
  EXPECT_GT(hits, 300);
  EXPECT_GT(misses, 300);
}

TEST_F(Drag, times_of_walls_and_fixed_balls_scale_and_turn_to_the_last_bit) {
  for (int k = 0; k < 3000; ++k) {
    const Vec<double> r{between(-4, 4), between(-4, 4)};
    if (dot(r, r) < 1.1) continue;
    const Vec<double> v{between(-3, 3), between(-3, 3)};
    const Vec<double> g{between(-2, 2), between(-4, 4)};
    const double rate = size();
    constexpr double kLength = 0x1p-20;
    constexpr double kTime = 0x1p7;
    const auto scaled = [](const Vec<double>& a, double by) { return by * a; };
    const double fixed_disk = damped_fixed_disk_time(r, v, g, 1.0, rate);
    EXPECT_EQ(damped_fixed_disk_time(scaled(r, kLength), scaled(v, kLength / kTime),
                                     scaled(g, kLength / kTime / kTime), kLength, rate / kTime),
              fixed_disk * kTime);
    const auto swapped = [](const Vec<double>& a) { return Vec<double>{a.y, a.x}; };
    const auto mirrored = [](const Vec<double>& a) { return Vec<double>{-a.x, a.y}; };
    EXPECT_EQ(damped_fixed_disk_time(swapped(r), swapped(v), swapped(g), 1.0, rate), fixed_disk);
    EXPECT_EQ(damped_fixed_disk_time(mirrored(r), mirrored(v), mirrored(g), 1.0, rate), fixed_disk);
    const double h = std::abs(r.x);
    EXPECT_EQ(damped_wall_time(h * kLength, v.x * (kLength / kTime),
                               g.x * (kLength / kTime / kTime), rate / kTime),
              damped_wall_time(h, v.x, g.x, rate) * kTime);
  }
}

TEST_F(Drag, four_flights_at_once_have_the_bits_of_one_at_a_time) {
  for (int k = 0; k < 3000; ++k) {
    const DampedLaw<double> law{{between(-2, 2), between(-4, 4)}, size()};
    const Flight<double> me{{between(-3, 3), between(-3, 3)}, {between(-3, 3), between(-3, 3)}};
    FlightLanes four{{}, {}, {}, {}, me.position, me.velocity, {}};
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      four.x[l] = between(-3, 3);
      four.y[l] = between(-3, 3);
      four.vx[l] = between(-3, 3);
      four.vy[l] = between(-3, 3);
      four.since[l] = either(size());
    }
    const RelativeLanes lanes = relative(law, four);
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      const Flight<double> other{{four.x[l], four.y[l]}, {four.vx[l], four.vy[l]}};
      const double since = four.since[l];
      const bool later = since > 0;
      const auto one =
          relative_at_later_start(law, later ? other : me, std::abs(since), later ? me : other);
      const double sign = later ? -1 : 1;
      EXPECT_EQ(lanes.dx[l], sign * one.r.x);
      EXPECT_EQ(lanes.dy[l], sign * one.r.y);
      EXPECT_EQ(lanes.dvx[l], sign * one.v.x);
      EXPECT_EQ(lanes.dvy[l], sign * one.v.y);
    }
  }
}

}  // namespace
}  // namespace carom::event::event_contact_drag_test
