#include "state/balls.hpp"

namespace carom {

Balls::Balls(const std::vector<Ball>& balls, const Effects& effects) {
  const std::size_t n = balls.size();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    position[axis].resize(n);
    velocity[axis].resize(n);
  }
  radius.resize(n);
  mass.resize(n);
  inverse_mass.resize(n);
  if (effects.friction) spin.resize(n);
  if (effects.attraction) {
    for (Column& column : pull) column = Column(n, 0.0);
  }
  glyph.reserve(balls.size());
  for (std::size_t i = 0; i < n; ++i) {
    const Ball& ball = balls[i];
    for (std::size_t axis = 0; axis < 2; ++axis) {
      position[axis][i] = ball.position[axis];
      velocity[axis][i] = ball.fixed ? 0 : ball.velocity[axis];
    }
    radius[i] = ball.radius;
    mass[i] = ball.mass;
    inverse_mass[i] = ball.fixed ? 0 : 1 / ball.mass;
    if (spin.size() > 0) spin[i] = ball.fixed ? 0 : ball.spin;
    glyph.push_back(ball.glyph);
  }
}

Ball Balls::ball(std::size_t i) const {
  const std::size_t k = i;
  Ball ball;
  ball.position = {position[0][k], position[1][k]};
  ball.velocity = {velocity[0][k], velocity[1][k]};
  ball.radius = radius[k];
  ball.mass = mass[k];
  if (spin.size() > 0) ball.spin = spin[k];
  ball.fixed = fixed(i);
  ball.glyph = glyph[i];
  return ball;
}

std::vector<Ball> Balls::to_vector() const {
  std::vector<Ball> balls;
  balls.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) balls.push_back(ball(i));
  return balls;
}

}  // namespace carom
