#include "solvers/event/crossing_time.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace carom::event {

namespace {

constexpr double kRoomForSpeed = 4;           // of the light balls of a mixture, in thermal speeds
constexpr double kMostRoomForSpeed = 0x1p16;  // of the fastest at the start

}  // namespace

std::array<double, 2> gravity_of(const Effects& effects) {
  if (!effects.gravity) return {0, 0};
  return {effects.gravity->acceleration.x(), effects.gravity->acceleration.y()};
}

double crossing_time(const Domain& domain, const Effects& effects, const std::vector<Ball>& balls) {
  const double width = domain.upper[0] - domain.lower[0];
  const double height = domain.upper[1] - domain.lower[1];
  double square = 0;
  double energy = 0;
  double lightest = 0;
  std::size_t moving = 0;
  for (const Ball& ball : balls) {
    if (ball.fixed) continue;
    const double speed_square = ball.velocity.squaredNorm();
    square = std::max(square, speed_square);
    energy += ball.mass * speed_square / 2;
    lightest = moving == 0 ? ball.mass : std::min(lightest, ball.mass);
    ++moving;
  }
  const auto [gx, gy] = gravity_of(effects);
  double speed = std::sqrt(square) + std::sqrt(std::abs(gx) * width + std::abs(gy) * height);
  if (moving > 0) {
    const double share = energy / static_cast<double>(moving);
    const double most = kMostRoomForSpeed * speed;
    speed = std::max(speed, std::min(most, kRoomForSpeed * std::sqrt(share / lightest)));
  }
  return speed > 0 ? std::min(width, height) / speed : 1;
}

}  // namespace carom::event
