#include "view/newcomer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace carom {
namespace {

constexpr int kTries = 2000;

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

bool is_free(const Ball& newcomer, const std::vector<Ball>& balls, const Box& box) {
  return std::none_of(balls.begin(), balls.end(), [&](const Ball& ball) {
    Vec2 apart = newcomer.position - ball.position;
    for (int axis = 0; axis < 2; ++axis) {
      const double size = box.size()[axis];
      if (box.periodic[static_cast<std::size_t>(axis)])
        apart[axis] -= size * std::round(apart[axis] / size);
    }
    return apart.norm() < newcomer.radius + ball.radius;
  });
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
  const Vec2 room = box.size() - Vec2::Constant(2 * ball.radius);
  for (int i = 0; i < kTries; ++i) {
    ball.position = box.lower() + Vec2::Constant(ball.radius) +
                    Vec2{room.x() * uniform(), room.y() * uniform()};
    if (is_free(ball, balls, box)) return ball;
  }
  return std::nullopt;
}

}  // namespace carom
