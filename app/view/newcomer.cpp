#include "view/newcomer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "carom/free_place.hpp"

namespace carom {
namespace {

Ball model(const std::vector<Ball>& balls, const Box& box) {
  for (auto ball = balls.rbegin(); ball != balls.rend(); ++ball) {
    if (ball->fixed) continue;
    Ball like;
    like.radius = ball->radius;
    like.mass = ball->mass;
    return like;
  }
  Ball like;
  like.radius = std::min(box.width, box.height) / 20;
  return like;
}

double typical_speed(const std::vector<Ball>& balls, const Box& box) {
  double sum = 0;
  for (const Ball& ball : balls) sum += ball.velocity.squaredNorm();
  const double mean = balls.empty() ? 0 : sum / static_cast<double>(balls.size());
  return mean > 0 ? std::sqrt(mean) : box.width / 4;
}

}  // namespace

std::optional<Ball> newcomer(const Session& session, std::uint64_t number) {
  const Box& box = session.scene().box;
  const std::vector<Ball> balls = session.simulation().state();
  Ball ball = model(balls, box);
  std::mt19937_64 random(session.scene().seed + number);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  const double angle = 2 * std::numbers::pi * uniform();
  ball.velocity = typical_speed(balls, box) * Vec2{std::cos(angle), std::sin(angle)};
  const auto place = find_free_place(session.scene(), balls, ball.radius, number);
  if (!place) return std::nullopt;
  ball.position = *place;
  return ball;
}

}  // namespace carom
