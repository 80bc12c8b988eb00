#include "view/spawn.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/free_place.hpp"

namespace carom {
namespace {

constexpr double kGoldenAngle = 2.399963229728653;  // spreads any number of directions evenly

Ball model(const std::vector<Ball>& balls, const Box& box) {
  Ball like;
  const auto newest =
      std::find_if(balls.rbegin(), balls.rend(), [](const Ball& ball) { return !ball.fixed; });
  if (newest == balls.rend()) {
    like.radius = std::min(box.width, box.height) / 20;
  } else {
    like.radius = newest->radius;
    like.mass = newest->mass;
  }
  return like;
}

double typical_speed(const std::vector<Ball>& balls, const Box& box) {
  double sum = 0;
  for (const Ball& ball : balls) sum += ball.velocity.squaredNorm();
  const double mean = balls.empty() ? 0 : sum / static_cast<double>(balls.size());
  return mean > 0 ? std::sqrt(mean) : box.width / 4;
}

}  // namespace

Ball model_ball(const Session& session) {
  return model(session.simulation().state(), session.scene().box);
}

std::optional<Ball> spawn(const Session& session, std::uint64_t number) {
  const std::vector<Ball> balls = session.simulation().state();
  Ball ball = model(balls, session.scene().box);
  const auto place = find_free_place(session.scene(), balls, ball.radius, number);
  if (!place) return std::nullopt;
  ball.position = *place;
  const double angle = kGoldenAngle * static_cast<double>(number + 1);
  ball.velocity =
      typical_speed(balls, session.scene().box) * Vec2{std::cos(angle), std::sin(angle)};
  return ball;
}

}  // namespace carom
