#include "trajectory/exit_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "solvers/event/exit_lanes.hpp"
#include "trajectory/damped_law.hpp"

namespace carom::event::event_exit_test {
namespace {

class EventExit : public testing::Test {
 protected:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double size() { return std::pow(10, between(-4, 2)); }
  double either(double a) { return between(-1, 1) < 0 ? -a : a; }

  std::mt19937_64 random_{3};
};

/// When a ball under the law leaves the interval (-1, 1), by the times of its two ends.
template <class Law>
double exit_time(const Law& law, double at, double v) {
  return std::min(law.wall_wait(0, 1, 1 + at, v), law.wall_wait(0, -1, 1 - at, -v));
}

template <class Law>
double bound(const Law& law, double at, double v) {
  const double forward = std::copysign(1.0, v) * at;
  return exit_bound<double>(1 - forward, 1 + forward, std::abs(v),
                            std::copysign(1.0, v) * law.push(0, v), law.fading());
}

// Breaks when a factor 2 of a push is lost, or drag's fading is taken for none.
TEST_F(EventExit, a_bound_is_never_after_the_ball_has_left) {
  int bent = 0;
  for (int k = 0; k < 20000; ++k) {
    const double at = between(-0.99, 0.99);
    const double v = k % 7 == 0 ? 0 : either(size());
    const DampedLaw<double> law{{k % 3 == 0 ? 0 : either(size()), 0}, k % 4 == 0 ? 0 : size()};
    const double exit = exit_time(law, at, v);
    const double earliest = bound(law, at, v);
    ASSERT_LE(earliest, exit * (1 + 1e-12))
        << at << ' ' << v << ' ' << law.gravity.x << ' ' << law.rate;
    const double straight =
        v == 0 ? never<double>() : (1 - std::copysign(at, at * v)) / std::abs(v);
    if (exit < never<double>() && exit != straight) ++bent;
    ASSERT_LE(square_exit_bound(law, TwoLanes{at, 0}, TwoLanes{v, 0}, 1.0), exit * (1 + 1e-12));
    const DampedLaw<double> swapped{{0, law.gravity.x}, law.rate};
    ASSERT_LE(square_exit_bound(swapped, TwoLanes{0, at}, TwoLanes{0, v}, 1.0), exit * (1 + 1e-12));
  }
  EXPECT_GT(bent, 5000);
}

TEST_F(EventExit, a_bound_is_little_before_the_ball_leaves_where_it_is_pushed_little) {
  for (int k = 0; k < 20000; ++k) {
    const double at = between(-0.9, 0.9);
    const double v = either(between(0.5, 2));
    const double rate = k % 2 == 0 ? 0 : between(0, 0.02);
    const DampedLaw<double> law{{between(-0.01, 0.01), 0}, rate};
    EXPECT_GE(bound(law, at, v), 0.97 * exit_time(law, at, v));
    EXPECT_GE(square_exit_bound(law, TwoLanes{at, 0}, TwoLanes{v, 0}, 1.0),
              0.9 * exit_time(law, at, v));
  }
}

TEST_F(EventExit, without_a_push_it_is_the_time_of_the_straight_way_and_at_rest_never) {
  const BallisticLaw<double> none{{0, 0}};
  EXPECT_EQ(bound(none, 0.5, 0.25), 2);
  EXPECT_EQ(bound(none, 0.5, -0.25), 6);
  EXPECT_EQ(bound(none, 0.5, 0), never<double>());
  EXPECT_EQ(bound(none, 1, 1), 0);
  EXPECT_EQ(square_exit_bound(none, TwoLanes{0.5, 0}, TwoLanes{0.25, 0}, 1.0), 2);
}

}  // namespace
}  // namespace carom::event::event_exit_test
