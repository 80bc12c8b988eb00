#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "effects/collisions.hpp"

namespace carom::contact_group_test {
namespace {

// Kinetic and potential, of balls of mass 1.
double energy(const std::vector<Ball>& balls, double fall) {
  double sum = 0;
  for (const Ball& ball : balls) sum += ball.velocity.squaredNorm() / 2 + fall * ball.position.y();
  return sum;
}

std::vector<Ball> resolved(const std::vector<Ball>& before, double fall, double restitution) {
  Box box;
  box.width = box.height = 8;
  const Domain domain(box, true);
  effects::CollisionRule rule;
  rule.restitution = rule.wall_restitution = restitution;
  rule.acceleration = {0, -fall};
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < before.size(); ++i) {
    for (std::uint32_t j = i + 1; j < before.size(); ++j) {
      if ((before[i].position - before[j].position).norm() < 1) pairs.push_back({i, j});
    }
  }
  Balls balls(before);
  effects::ImpactCount count;
  Turns turns;
  effects::GroupResolver(domain, rule, turns).resolve(balls, pairs, false, count);
  return balls.to_vector();
}

std::vector<Ball> at(const std::vector<Vec2>& places) {
  std::vector<Ball> balls;
  balls.reserve(places.size());
  for (const Vec2& place : places) balls.push_back(Ball{place});
  return balls;
}

// The floor stops the lowest ball while it is moved apart from its neighbours, who are thereby
// lifted; afterwards it is moved up too, and stands at no wall any more.
TEST(ContactGroup, BallsThatTheFloorHeldForAMomentAreNotLiftedForNothing) {
  const double fall = 8;
  for (const auto& places : {std::vector<Vec2>{{3.1875, 1.125}, {3.6875, 0.5625}, {4.5, 1.125}},
                             std::vector<Vec2>{{4.3125, 1}, {4.3125, 1.25}, {4.3125, 0.5625}}}) {
    for (const double restitution : {0.0, 0.5, 1.0}) {
      const std::vector<Ball> before = at(places);
      const std::vector<Ball> after = resolved(before, fall, restitution);
      EXPECT_LE(energy(after, fall), energy(before, fall) * (1 + 1e-14)) << restitution;
    }
  }
}

TEST(ContactGroup, BallsThatFallTogetherAndTouchNothingElseKeepTheirMomentum) {
  std::vector<Ball> before = at({{4, 4}, {4.75, 4.25}, {4.25, 4.75}});
  before[0].velocity = {1, -3};
  before[1].velocity = {-2, -4};
  const std::vector<Ball> after = resolved(before, 8, 0.5);
  Vec2 momentum{0, 0};
  Vec2 places{0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    momentum += after[i].velocity - before[i].velocity;
    places += after[i].position - before[i].position;
  }
  EXPECT_LE(momentum.norm(), 1e-14);
  EXPECT_LE(places.norm(), 1e-14);
}

}  // namespace
}  // namespace carom::contact_group_test
