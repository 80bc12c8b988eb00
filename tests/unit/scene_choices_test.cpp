// What a scene gets where it does not say, and what is allowed though it is odd: as the contract of
// the scene has it.
#include <gtest/gtest.h>

#include "carom/scene_file.hpp"
#include "carom/session.hpp"

namespace carom::scene_choices_test {
namespace {

Scene falling(std::size_t balls, double restitution) {
  Scene scene;
  scene.box.width = 100;
  scene.box.height = 100;
  scene.effects.walls = Walls{restitution};
  scene.effects.collisions = Collisions{restitution};
  scene.effects.gravity = Gravity{};
  scene.fills.push_back({});
  scene.fills[0].count = balls;
  return scene;
}

TEST(DefaultMethod, IsEventButForManyBallsThatCanPileUp) {
  EXPECT_EQ(choose_method(falling(1, 0.5)).method, Method::event);
  EXPECT_EQ(choose_method(falling(300, 0.5)).method, Method::event);
  EXPECT_FALSE(choose_method(falling(300, 0.5)).piles_up);
  const MethodChoice many = choose_method(falling(301, 0.5));
  EXPECT_EQ(many.method, Method::overlap);
  EXPECT_TRUE(many.piles_up);
  EXPECT_EQ(many.why, kPilesUp);
}

TEST(DefaultMethod, IsEventForManyBallsThatCannot) {
  Scene scene = falling(1000, 1);
  EXPECT_EQ(choose_method(scene).method, Method::event);
  scene = falling(1000, 0.5);
  scene.effects.gravity.reset();
  EXPECT_EQ(choose_method(scene).method, Method::event);
  scene = falling(1000, 0.5);
  scene.effects.collisions.reset();
  EXPECT_EQ(choose_method(scene).method, Method::event);
  // Fixed ones do not fall.
  scene = falling(300, 0.5);
  for (int k = 0; k < 50; ++k) {
    scene.balls.push_back(Ball{{1.5 + 1.8 * k, 50}});
    scene.balls.back().fixed = true;
  }
  EXPECT_EQ(choose_method(scene).method, Method::event);
}

TEST(DefaultMethod, FollowsEveryLoss) {
  for (int which = 0; which < 4; ++which) {
    Scene scene = falling(400, 1);
    if (which == 0) scene.effects.walls->restitution = 0.9;
    if (which == 1) scene.effects.drag = Drag{0.1};
    if (which == 2) scene.effects.friction = Friction{0.1, 0.1};
    if (which == 3) {
      command::SetEffects set;
      set.effects.walls = Walls{0.5};
      scene.script.push_back({1, set});
    }
    EXPECT_EQ(choose_method(scene).method, Method::overlap) << which;
  }
}

TEST(DefaultMethod, IsTheOneNamed) {
  Scene scene = falling(1000, 0.5);
  scene.solver.method = Method::event;
  EXPECT_EQ(choose_method(scene).method, Method::event);
  EXPECT_FALSE(choose_method(scene).piles_up);
}

// A funnel of fixed balls with a ball above it that must come to lie in it.
// Seen to fail: they were refused, listed and added.
TEST(FixedBalls, MayOverlapEachOther) {
  for (const Method method : {Method::event, Method::overlap}) {
    Scene scene;
    scene.box.width = 10;
    scene.box.height = 12;
    scene.effects.walls = Walls{0.5};
    scene.effects.collisions = Collisions{0.5};
    scene.effects.gravity = Gravity{};
    scene.solver.method = method;
    scene.workers = 1;
    for (const double x : {3.0, 3.6, 4.2, 4.2}) {
      scene.balls.push_back(Ball{{x, 2}});
      scene.balls.back().fixed = true;
    }
    scene.balls.push_back(Ball{{3.3, 6}});
    scene.balls.back().radius = 0.3;
    EXPECT_TRUE(find_problems(scene).empty());
    Session session(scene);
    session.advance_clock_to(5);
    Ball another{{4.4, 2.2}};
    another.fixed = true;
    session.apply(command::Add{another});
    EXPECT_THROW(session.apply(command::Add{Ball{{4.4, 2.2}}}), CommandError);
    session.advance_clock_to(6);
    const std::vector<Ball> balls = session.simulation().state();
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(balls[k].position, scene.balls[k].position);
    const double apart = (balls[4].position - balls[0].position).norm();
    EXPECT_GE(apart, 0.8 - 1e-2);
  }
}

TEST(FixedBalls, MayNotBeOverlappedByWhatMoves) {
  Scene scene;
  scene.effects.collisions = Collisions{};
  scene.balls = {Ball{{3, 3}}, Ball{{3.5, 3}}, Ball{{4, 3}}};
  scene.balls[0].fixed = scene.balls[1].fixed = true;
  const std::vector<Problem> problems = find_problems(scene);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].place, "/balls/2");
  EXPECT_NE(problems[0].message.find("/balls/1"), std::string::npos);
}

Scene two_balls(Method method) {
  Scene scene;
  scene.box.width = 4;
  scene.box.height = 4;
  scene.effects.walls = Walls{};
  scene.effects.collisions = Collisions{};
  scene.solver.method = method;
  scene.workers = 1;
  scene.balls = {Ball{{1, 1}, {1, 0.5}}, Ball{{3, 1}}};
  return scene;
}

// Seen to fail: a duration was refused for steps that event does not take.
TEST(Duration, IsCountedInStepsOnlyWhereStepsAreTaken) {
  Scene scene = two_balls(Method::event);
  for (Ball& ball : scene.balls) ball.velocity *= 1e-12;
  scene.duration = 1e14;
  scene.frame_rate = 1e-13;
  EXPECT_TRUE(find_problems(scene).empty());
  scene.effects.attraction = Attraction{};
  ASSERT_EQ(find_problems(scene).size(), 1U);
  EXPECT_EQ(find_problems(scene)[0].place, "/duration");
  scene.effects.attraction.reset();
  scene.solver.method = Method::overlap;
  ASSERT_EQ(find_problems(scene).size(), 1U);
  EXPECT_EQ(find_problems(scene)[0].place, "/duration");
}

// The light ball is hit at 1 m/s and flies off at 2: nothing in the run is fast.
// Seen to fail: a tick for the light ball's share of the energy made the run endless.
TEST(Duration, MassRatiosDoNotMakeARunEndless) {
  for (const double mass : {1e-12, 1e-30, 1e-70}) {
    Scene scene = two_balls(Method::event);
    scene.balls[1].mass = mass;
    scene.balls[0].velocity = {1, 0};
    EXPECT_TRUE(find_problems(scene).empty());
    Simulation simulation(scene);
    simulation.advance_to(1.2);
    EXPECT_NEAR(simulation.state()[1].velocity.x(), 2, 1e-11);
    EXPECT_NEAR(simulation.state()[1].position.x(), 3.4, 1e-11);
  }
}

TEST(Duration, SpeedsThatMakeARunEndlessAreRefusedByName) {
  Scene scene = two_balls(Method::event);
  scene.balls[0].velocity = {0, 1e30};
  ASSERT_EQ(find_problems(scene).size(), 1U);
  EXPECT_EQ(find_problems(scene)[0].place, "/balls/0/velocity");
  scene.balls[0].velocity = {1, 0};
  scene.effects.gravity = Gravity{{0, -1e50}};
  ASSERT_EQ(find_problems(scene).size(), 1U);
  EXPECT_EQ(find_problems(scene)[0].place, "/effects/gravity");
  scene.effects.gravity = Gravity{};
  command::SetEffects set;
  set.effects.gravity = Gravity{{1e40, 0}};
  scene.script.push_back({1, set});
  ASSERT_EQ(find_problems(scene).size(), 1U);
  EXPECT_EQ(find_problems(scene)[0].place, "/script/0/effects/gravity");
  scene.solver.method = Method::overlap;
  EXPECT_TRUE(find_problems(scene).empty());
}

}  // namespace
}  // namespace carom::scene_choices_test
