#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "support/event_course.hpp"

namespace carom::event_rest_test {
namespace {

using test::contact_ball;
using test::contact_box;
using test::Course;
using test::fixed_ball;
using test::speed;

// Dropped from h, bounce n reaches e^(2n) h, at t0 (1 + 2 (e + e^2 + ... + e^(n-1)) + e^n); it
// rests at t0 (1 + e) / (1 - e), with t0 = sqrt(2 h / g).
TEST(EventRest, a_dropped_ball_bounces_as_high_as_it_should_and_rests_when_it_should) {
  for (const double e : {0.3, 0.8, 0.95}) {
    Course run(contact_box(10, 10, e), {contact_ball(5, 1.5)});
    const double fall = std::sqrt(2 / 9.81);
    double apex = fall;
    double half = 0;
    for (int n = 1; n <= 20; ++n) {
      apex += half;
      half = fall * std::pow(e, n);
      apex += half;
      const double height = run.at(apex)[0].position.y() - 0.5;
      EXPECT_NEAR(height, std::pow(e, 2 * n), 1e-12) << e << " bounce " << n;
    }
    const double rest = fall * (1 + e) / (1 - e);
    run.at(rest * (1 - 1e-9));
    EXPECT_EQ(run.measured().resting_contacts, 0U) << e;
    const std::vector<Ball> end = run.at(rest * (1 + 1e-9));
    EXPECT_EQ(end[0].position.y(), 0.5);
    EXPECT_EQ(end[0].velocity.y(), 0);
    EXPECT_EQ(run.measured().resting_contacts, 1U);
    const std::uint64_t impacts = run.impacts();
    EXPECT_LE(impacts, 10 + 40 / -std::log(e));
    EXPECT_EQ(run.at(1000 * rest)[0].position.y(), 0.5);
    EXPECT_EQ(run.impacts(), impacts);
  }
}

TEST(EventRest, a_ball_that_loses_all_rests_at_the_first_touch) {
  Course run(contact_box(10, 10, 0), {contact_ball(5, 1.5, 1)});
  const Ball end = run.at(3)[0];
  EXPECT_EQ(run.impacts(), 1U);
  EXPECT_EQ(end.position.y(), 0.5);
  EXPECT_NEAR(end.position.x(), 8, 1e-14);
}

TEST(EventRest, a_ball_that_lies_on_the_floor_stays_whatever_its_restitution) {
  for (const double e : {0.0, 0.5, 1.0}) {
    Course run(contact_box(10, 10, e), {contact_ball(5, 0.5), contact_ball(7, 0.5)});
    EXPECT_EQ(run.at(50)[0].position.y(), 0.5) << e;
    EXPECT_EQ(run.at(100)[1].position.y(), 0.5) << e;
    EXPECT_EQ(run.impacts(), 0U) << e;
  }
}

TEST(EventRest, any_wall_and_any_direction_of_gravity_hold_a_ball) {
  const std::vector<Vec2> pulls{{0, 5}, {5, 0}, {-5, 0}, {3, -4}, {-3, 4}};
  for (const Vec2& pull : pulls) {
    Course run(contact_box(8, 6, 0.5, pull), {contact_ball(4, 3)});
    const Ball end = run.at(60)[0];
    if (pull.x() != 0) {
      EXPECT_EQ(end.position.x(), pull.x() < 0 ? 0.5 : 7.5);
    }
    if (pull.y() != 0) {
      EXPECT_EQ(end.position.y(), pull.y() < 0 ? 0.5 : 5.5);
    }
    EXPECT_EQ(speed(end), 0);
  }
}

// On the floor it glides like a free ball: v e^n after n side walls.
TEST(EventRest, a_ball_that_rests_on_the_floor_glides_on_and_turns_at_the_side_walls) {
  Course run(contact_box(10, 10, 0.5), {contact_ball(5, 1.5, 1)});
  const double fall = std::sqrt(2 / 9.81);
  const Ball before = run.at(3 * fall + 0.1)[0];
  EXPECT_EQ(before.position.y(), 0.5);
  EXPECT_NEAR(before.position.x(), 5 + 3 * fall + 0.1, 1e-13);
  const Ball after = run.at(4.5 + 2)[0];
  EXPECT_EQ(after.velocity.x(), -0.5);
  EXPECT_NEAR(after.position.x(), 9.5 - 1, 1e-13);
  EXPECT_EQ(after.position.y(), 0.5);
}

// The lying one does not accelerate, the falling one does: the gap of the two closed forms is
// bisected.
TEST(EventRest, a_ball_that_falls_on_one_that_lies_meets_it_where_the_two_paths_say) {
  const double g = 10;
  Course run(contact_box(20, 20, 0.5, {0, -g}),
             {contact_ball(5, 0.5, 1), contact_ball(5.75, 6.5, 0.5)});
  const auto gap = [&](double t) {
    const double x = 0.75 - 0.5 * t;
    const double y = 6 - g * t * t / 2;
    return x * x + y * y - 1;
  };
  double low = 0.5;
  double high = 1.1;
  while (high - low > 1e-14) {
    const double middle = (low + high) / 2;
    (gap(middle) > 0 ? low : high) = middle;
  }
  run.at(low - 1e-12);
  EXPECT_EQ(run.measured().ball_ball, 0U);
  run.at(high + 1e-12);
  EXPECT_GE(run.measured().ball_ball, 1U);
}

TEST(EventRest, a_ball_dropped_on_the_top_of_a_fixed_one_rests_there) {
  Course run(contact_box(10, 10, 0.5), {fixed_ball(5, 3), contact_ball(5, 5)});
  const double rest = std::sqrt(2 / 9.81) * 3;
  run.at(rest * 0.999);
  EXPECT_EQ(run.measured().resting_contacts, 0U);
  const Ball end = run.at(rest * 1.001)[1];
  EXPECT_EQ(run.measured().resting_contacts, 1U);
  EXPECT_NEAR(end.position.y(), 4, 1e-14);
  EXPECT_EQ(speed(end), 0);
  const std::uint64_t impacts = run.impacts();
  run.at(100);
  EXPECT_EQ(run.impacts(), impacts);
}

// Its flight begins again each time the clock counts from 0 again, at whole powers of two of
// seconds.
TEST(EventRest, a_ball_on_the_top_of_a_fixed_one_stays_there_however_long_it_is_hit) {
  Scene scene = contact_box(10, 10, 0.5);
  scene.effects.collisions = Collisions{1};
  Course run(scene, {fixed_ball(5, 3), contact_ball(5, 4), contact_ball(5, 6)});
  const double period = 2 * std::sqrt(2 / 9.81);
  for (int bounce = 1; bounce <= 80; ++bounce) {
    const std::vector<Ball> end = run.at(bounce * period);
    ASSERT_EQ(end[1].position.y(), 4) << bounce;
    ASSERT_NEAR(end[2].position.y(), 6, 1e-11) << bounce;
  }
}

TEST(EventRest, a_ball_beside_the_top_of_a_fixed_one_slides_off) {
  Course run(contact_box(10, 10, 0.5), {fixed_ball(5, 3), contact_ball(5 + 1e-6, 5)});
  EXPECT_LT(run.at(30)[1].position.y(), 1);
}

TEST(EventRest, a_ball_comes_to_rest_between_two_fixed_ones_and_between_one_and_a_wall) {
  const double height = std::sqrt(0.75);
  Course two(contact_box(10, 10, 0.4),
             {fixed_ball(4.5, 3), fixed_ball(5.5, 3), contact_ball(5.1, 5, 0.3)});
  const Ball on_two = two.at(20)[2];
  EXPECT_NEAR(on_two.position.x(), 5, 1e-6);
  EXPECT_NEAR(on_two.position.y(), 3 + height, 1e-6);
  EXPECT_EQ(speed(on_two), 0);
  Course wall(contact_box(10, 10, 0.4), {fixed_ball(1, 3), contact_ball(0.5, 6)});
  const Ball wedged = wall.at(20)[1];
  EXPECT_EQ(wedged.position.x(), 0.5);
  EXPECT_NEAR(wedged.position.y(), 3 + height, 1e-6);
  EXPECT_EQ(speed(wedged), 0);
  const std::uint64_t impacts = wall.impacts();
  wall.at(200);
  EXPECT_EQ(wall.impacts(), impacts);
}

// 2/3 of its speed when it rolls, after v / (3 mu g).  Fails where what slides is not stepped.
TEST(EventRest, a_ball_that_is_thrown_along_a_floor_ends_rolling_on_it) {
  Scene scene = contact_box(100, 10, 0.5);
  scene.effects.friction = Friction{0.3, 0.2};
  Course run(scene, {contact_ball(5, 0.5, 6)});
  for (int look = 1; look < 20; ++look) {
    const Ball b = run.at(0.05 * look)[0];
    EXPECT_NEAR(b.velocity.x(), 6 - 0.2 * 9.81 * 0.05 * look, 0.1) << look;
    EXPECT_NEAR(b.position.y(), 0.5, 2e-3) << look;
  }
  const Ball end = run.at(6 / (3 * 0.2 * 9.81) + 0.5)[0];
  EXPECT_EQ(end.position.y(), 0.5);
  EXPECT_NEAR(end.velocity.x(), 4, 1e-4);
  EXPECT_NEAR(end.spin, -8, 2e-4);
}

}  // namespace
}  // namespace carom::event_rest_test
