#include "solvers/event/event_rate.hpp"

#include <algorithm>
#include <cmath>

namespace carom::event {

void BallsOfBox::add(double radius, double square_speed) {
  squares += square_speed;
  diameters += 2 * radius;
  covered += 3.14159 * radius * radius;
}

double guessed_event_rate(const BallsOfBox& balls) {
  const auto n = static_cast<double>(std::max<std::size_t>(balls.count, 1));
  const double speed = std::sqrt(balls.squares / n + balls.gravity * std::sqrt(balls.area));
  const double packing = std::min(balls.covered / balls.area, 0.8);
  const double contact = (1 - packing / 2) / ((1 - packing) * (1 - packing));
  const double across =
      n / balls.area * (balls.diameters / n) * contact + 1 / std::sqrt(balls.area);
  return 4 * n * speed * across;
}

}  // namespace carom::event
