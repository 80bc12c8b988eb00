#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "solvers/event/solver.hpp"
#include "support/advance.hpp"

namespace carom::event_rest_symmetry_test {
namespace {

// Balls of all sizes that fall on fixed ones and come to rest on them, on each other and on walls.
Scene heap() {
  Scene scene;
  scene.box.width = 6;
  scene.box.height = 12;
  scene.box.origin = Box::Origin::center;
  scene.effects.walls = Walls{0.4};
  scene.effects.collisions = Collisions{0.3};
  scene.effects.gravity = Gravity{{0.5, -4}};
  std::mt19937_64 random(3);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      Ball ball;
      ball.position = {-2.2 + 1.3 * column + 0.1 * uniform(), -4 + 1.3 * row + 0.1 * uniform()};
      ball.velocity = {uniform() - 0.5, uniform() - 0.5};
      ball.radius = 0.4 + 0.2 * uniform();
      ball.mass = 0.5 + uniform();
      scene.balls.push_back(ball);
    }
  }
  scene.balls[5].fixed = true;
  return scene;
}

class Course {
 public:
  explicit Course(const Scene& scene)
      : solver_(std::make_unique<EventSolver>(scene, scene.balls)) {}

  void advance(double time) { test::advance(*solver_, time); }
  std::vector<Ball> balls() const { return solver_->state(); }
  Measurements measured() const {
    Measurements result;
    solver_->count(result);
    return result;
  }
  Scene saved(Scene scene, double time) const {
    scene.balls = solver_->state();
    scene.continuation.emplace();
    scene.continuation->time = time;
    solver_->save(scene);
    solver_->visit_flights(
        [&scene](const SavedFlight& flight) { scene.continuation->flights.push_back(flight); });
    return scene;
  }

 private:
  std::unique_ptr<Solver> solver_;
};

constexpr double kEnd = 12;

using Change = std::function<Vec2(const Vec2&)>;

void expect_same(const Course& expected, const Course& got, const Change& place,
                 const Change& velocity) {
  ASSERT_GT(expected.measured().resting_contacts, 12U);
  EXPECT_EQ(expected.measured().ball_ball, got.measured().ball_ball);
  EXPECT_EQ(expected.measured().ball_wall, got.measured().ball_wall);
  EXPECT_EQ(expected.measured().resting_contacts, got.measured().resting_contacts);
  const std::vector<Ball> a = expected.balls();
  const std::vector<Ball> b = got.balls();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(place(a[i].position), b[i].position) << i;
    EXPECT_EQ(velocity(a[i].velocity), b[i].velocity) << i;
  }
}

Scene changed(Scene scene, const Change& place, const Change& velocity,
              const Change& acceleration) {
  for (Ball& ball : scene.balls) {
    ball.position = place(ball.position);
    ball.velocity = velocity(ball.velocity);
  }
  scene.effects.gravity->acceleration = acceleration(scene.effects.gravity->acceleration);
  return scene;
}

class EventRestSymmetry : public testing::Test {
 protected:
  EventRestSymmetry() : scene_(heap()), straight_(scene_) { straight_.advance(kEnd); }

  void compare(const Scene& other, const Change& place, const Change& velocity, double times = 1) {
    Course course(other);
    course.advance(kEnd * times);
    expect_same(straight_, course, place, velocity);
  }

  Scene scene_;
  Course straight_;
};

TEST_F(EventRestSymmetry, mirrored_heaps_come_to_rest_as_mirror_images) {
  const Change left = [](const Vec2& v) { return Vec2{-v.x(), v.y()}; };
  compare(changed(scene_, left, left, left), left, left);
  const Change down = [](const Vec2& v) { return Vec2{v.x(), -v.y()}; };
  compare(changed(scene_, down, down, down), down, down);
}

TEST_F(EventRestSymmetry, a_heap_with_x_and_y_swapped_comes_to_rest_swapped) {
  const Change swap = [](const Vec2& v) { return Vec2{v.y(), v.x()}; };
  Scene other = changed(scene_, swap, swap, swap);
  std::swap(other.box.width, other.box.height);
  compare(other, swap, swap);
}

TEST_F(EventRestSymmetry, the_order_of_the_balls_changes_no_bit_of_a_heap) {
  Scene other = scene_;
  std::reverse(other.balls.begin(), other.balls.end());
  Course course(other);
  course.advance(kEnd);
  std::vector<Ball> got = course.balls();
  std::reverse(got.begin(), got.end());
  const std::vector<Ball> expected = straight_.balls();
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_EQ(expected[i].position, got[i].position) << i;
    EXPECT_EQ(expected[i].velocity, got[i].velocity) << i;
  }
}

TEST_F(EventRestSymmetry, lengths_times_and_masses_times_powers_of_two_give_the_same_heap) {
  const double length = 0x1p-7;
  const double time = 0x1p5;
  const Change place = [&](const Vec2& v) { return Vec2(v * length); };
  const Change velocity = [&](const Vec2& v) { return Vec2(v * (length / time)); };
  const Change acceleration = [&](const Vec2& v) { return Vec2(v * (length / time / time)); };
  Scene other = changed(scene_, place, velocity, acceleration);
  other.box.width *= length;
  other.box.height *= length;
  for (Ball& ball : other.balls) {
    ball.radius *= length;
    ball.mass *= 0x1p11;
  }
  compare(other, place, velocity, time);
}

TEST_F(EventRestSymmetry, looking_at_a_heap_changes_no_bit) {
  const Change same = [](const Vec2& v) { return v; };
  Course course(scene_);
  for (int frame = 1; frame <= 700; ++frame) course.advance(kEnd * frame / 700);
  expect_same(straight_, course, same, same);
}

TEST_F(EventRestSymmetry, a_heap_that_is_saved_at_any_time_goes_on_with_the_same_bits) {
  for (const double stop : {0.7, 1.3, 2.9, 4.1, 9.0}) {
    Course first(scene_);
    first.advance(stop);
    Course second(first.saved(scene_, stop));
    second.advance(kEnd);
    const std::vector<Ball> expected = straight_.balls();
    const std::vector<Ball> got = second.balls();
    for (std::size_t i = 0; i < got.size(); ++i) {
      EXPECT_EQ(expected[i].position, got[i].position) << stop << ' ' << i;
      EXPECT_EQ(expected[i].velocity, got[i].velocity) << stop << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace carom::event_rest_symmetry_test
