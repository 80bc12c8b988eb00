// Piles of so many contacts that an interior point solves them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

#include "carom/scene_file.hpp"
#include "carom/session.hpp"
#include "support/event_contact.hpp"

namespace carom::event_pile_test {
namespace {

/// Balls above each other, a little off a lattice, that fall into a box with losses.
struct Pile {
  Scene scene;
  std::vector<Ball> balls;
};

Pile pile(std::size_t count, double unit) {
  Pile result;
  result.scene = test::contact_box(12 * unit, 40 * unit, 0.3, {0, -9.81 * unit});
  std::mt19937 random(7);
  const auto below = [&random](unsigned n) { return static_cast<double>(random() % n); };
  for (std::size_t k = 0; k < count; ++k) {
    const double x = 0.5 + 1.0625 * static_cast<double>(k % 11) + below(64) / 1024;
    const std::size_t rows_below = k / 11;
    const double y = 0.5 + 1.125 * static_cast<double>(rows_below) + below(64) / 1024;
    Ball ball = test::contact_ball(x * unit, y * unit, (below(64) / 64 - 0.5) * unit);
    ball.radius = 0.5 * unit;
    result.balls.push_back(ball);
  }
  return result;
}

// Seen to fail where the balls of an island are solved in the order in which they are listed.
TEST(EventContact, neither_order_nor_unit_changes_a_bit_of_a_pile) {
  const Pile start = pile(140, 1);
  const test::ContactOutcome end = test::run_contact(start.scene, start.balls, 1.5);
  std::vector<std::size_t> from(start.balls.size());
  std::iota(from.begin(), from.end(), 0U);
  std::mt19937 random(1);
  for (const double unit : {1.0, 0.25}) {
    std::shuffle(from.begin(), from.end(), random);
    const Pile other = pile(140, unit);
    std::vector<Ball> balls;
    for (const std::size_t k : from) balls.push_back(other.balls[k]);
    const test::ContactOutcome again = test::run_contact(other.scene, balls, 1.5);
    for (std::size_t k = 0; k < from.size(); ++k) {
      EXPECT_EQ(unit * end.balls[from[k]].position, again.balls[k].position) << k << ' ' << unit;
      EXPECT_EQ(unit * end.balls[from[k]].velocity, again.balls[k].velocity) << k << ' ' << unit;
    }
  }
}

// It comes to rest, no ball is in another, and the book has what was lost.
TEST(EventContact, a_pile_of_many_contacts_comes_to_rest) {
  const Pile start = pile(140, 1);
  const test::ContactOutcome end = test::run_contact(start.scene, start.balls, 20);
  for (const Ball& ball : end.balls) EXPECT_EQ(ball.velocity, (Vec2{0, 0}));
  EXPECT_LT(end.measured.max_overlap, 1e-3);
  EXPECT_NEAR(end.energy + end.dissipated, end.energy_before, 1e-12 * end.energy_before);
}

// Each impact on a heap moves all of it: those of a step are resolved together. Seen to fail: with
// some 1,700 joint impacts, where each is resolved at its own time.
TEST(EventContact, a_heap_that_forms_is_hit_a_few_times_a_step) {
  const Pile start = pile(300, 1);
  const test::ContactOutcome end = test::run_contact(start.scene, start.balls, 3);
  EXPECT_LT(end.measured.max_overlap, 1e-3);
  EXPECT_NEAR(end.energy + end.dissipated, end.energy_before, 1e-12 * end.energy_before);
  // A step is 1/128 s.
  EXPECT_LT(end.measured.joint_impacts, 3U * 128 * 3);
}

// Of a heap of 60 balls the same holds. Seen to fail, with 358, where it is not large enough for
// that.
TEST(EventContact, a_heap_of_sixty_is_hit_less_than_once_a_step) {
  const Pile start = pile(60, 1);
  const test::ContactOutcome end = test::run_contact(start.scene, start.balls, 3);
  EXPECT_LT(end.measured.max_overlap, 1e-3);
  EXPECT_NEAR(end.energy + end.dissipated, end.energy_before, 1e-12 * end.energy_before);
  // Two in three of its steps, of 1/128 s.
  EXPECT_LT(end.measured.joint_impacts, 2U * 128);
}

// A heap of 200 balls that creeps: a ball that touches it lies on the floor, and another rolls
// there. Neither may leave the island in each step only to be hit by it at once, with all of it.
// Seen to fail: with 3232 impacts, where what leaves is not asked what comes nearer.
TEST(EventContact, a_heap_that_creeps_is_not_hit_in_every_step) {
  Scene scene = read_scene(CAROM_SOURCE_DIR "/tests/hard/heap_nearly_at_rest.json");
  scene.workers = 1;
  Session session(scene);
  session.advance_clock_to(scene.continuation->clock + 0.25);
  // A step is 1/128 s: fewer impacts than a tenth of the balls have in each.
  EXPECT_LT(session.simulation().measure().ball_ball, 32 * 20);
}

}  // namespace
}  // namespace carom::event_pile_test
