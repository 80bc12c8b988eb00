#include "state/totals.hpp"

#include <bit>

namespace carom {

double kinetic_energy(const Ball& ball, bool spins) {
  if (ball.fixed) return 0;
  const double surface = spins ? ball.radius * ball.spin : 0;
  return ball.mass * (ball.velocity.squaredNorm() / 2 + surface * surface / 4);
}

double kinetic_energy(const Balls& balls) {
  double sum = 0;
  for (std::size_t i = 0; i < balls.radius.size(); ++i) {
    const double vx = balls.velocity[0][i];
    const double vy = balls.velocity[1][i];
    sum += balls.mass[i] * (vx * vx + vy * vy) / 2;
  }
  return sum;
}

double spin_energy(const Balls& balls) {
  double sum = 0;
  for (std::size_t i = 0; i < balls.radius.size(); ++i) {
    const double speed = balls.radius[i] * balls.spin[i];
    sum += balls.mass[i] * speed * speed / 4;
  }
  return sum;
}

double potential_energy(const Balls& balls, const Vec2& gravity, const Vec2& periods,
                        const Turns& turns) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto k = axis;
    if (gravity[k] == 0) continue;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      if (balls.fixed(i)) continue;
      double x = balls.at(i)[k];
      if (!turns[axis].empty()) x += static_cast<double>(turns[axis][i]) * periods[k];
      sum -= balls.mass[i] * gravity[k] * x;
    }
  }
  return sum;
}

Vec2 momentum(const Balls& balls) {
  Vec2 sum{0, 0};
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const std::size_t k = i;
    sum += balls.mass[k] * Vec2{balls.velocity[0][k], balls.velocity[1][k]};
  }
  return sum;
}

namespace {

// Each 64-bit word is mixed whole (splitmix64's finaliser: Steele, Lea, Flood 2014), so that a
// difference of one bit anywhere changes the digest.
std::uint64_t mixed(std::uint64_t digest, double value) {
  digest = (digest ^ std::bit_cast<std::uint64_t>(value)) + 0x9e3779b97f4a7c15U;
  digest = (digest ^ (digest >> 30U)) * 0xbf58476d1ce4e5b9U;
  digest = (digest ^ (digest >> 27U)) * 0x94d049bb133111ebU;
  return digest ^ (digest >> 31U);
}

}  // namespace

std::string state_hash(const Balls& balls) {
  StateHash hash(balls.size(), balls.spin.size() > 0);
  for (std::size_t i = 0; i < balls.size(); ++i) hash.add(balls.ball(i));
  return hash.text();
}

void StateHash::add(const Ball& ball) {
  for (std::size_t k = 0; k < 2; ++k) digest_ = mixed(digest_, ball.position[k]);
  for (std::size_t k = 0; k < 2; ++k) digest_ = mixed(digest_, ball.fixed ? 0 : ball.velocity[k]);
  if (spins_) digest_ = mixed(digest_, ball.fixed ? 0 : ball.spin);
}

std::string StateHash::text() const {
  std::string text(16, '0');
  for (std::size_t k = 0; k < text.size(); ++k) {
    text[text.size() - 1 - k] = "0123456789abcdef"[(digest_ >> (4 * k)) & 15U];
  }
  return text;
}

void Totals::add(const Ball& ball) {
  const std::size_t i = number_++;
  if (ball.fixed) return;
  kinetic_ += ball.mass * ball.velocity.squaredNorm() / 2;
  momentum_ += ball.mass * ball.velocity;
  if (spins_) {
    const double speed = ball.radius * ball.spin;
    spin_ += ball.mass * speed * speed / 4;
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (gravity_[axis] == 0) continue;
    double x = ball.position[axis];
    if (!turns_[axis].empty()) x += static_cast<double>(turns_[axis][i]) * periods_[axis];
    potential_[axis] -= ball.mass * gravity_[axis] * x;
  }
}

}  // namespace carom
