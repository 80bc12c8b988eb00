#include "effects/drag.hpp"

#include <algorithm>
#include <cmath>

namespace carom::effects {
namespace {

// (z - 1 + exp(-z)) / z^2, which is 1/2 at 0.
double second_remainder(double z) {
  if (z >= 0.5) return (z + std::expm1(-z)) / (z * z);
  double sum = 0.5;
  double term = 0.5;
  for (int n = 3; term != 0 && sum + term != sum; ++n) {
    term *= -z / n;
    sum += term;
  }
  return sum;
}

}  // namespace

Glide slowed(double rate, double step, double acceleration) {
  const double z = rate * step;
  const double reach = z != 0 ? -std::expm1(-z) / rate : step;
  return {reach,
          std::exp(-z),
          acceleration * step * step * second_remainder(z),
          acceleration * reach,
          DragLoss(rate, step),
          acceleration};
}

void drag(Flight& flight) {
  const double reach = flight.glide.reach;
  const double keep = flight.glide.keep;
  for (std::size_t k = 0; k < flight.count; ++k) {
    flight.moved[k] = flight.velocity[k] * reach;
    flight.after[k] = flight.velocity[k] * keep;
  }
  if (flight.lost == nullptr) return;
  const DragLoss& loss = flight.glide.drag_loss;
  const double acceleration = flight.glide.acceleration;
  for (std::size_t k = 0; k < flight.count; ++k) {
    const bool moves = flight.inverse_mass[k] > 0;
    flight.lost[k] += moves ? flight.mass[k] * loss.along(flight.velocity[k], acceleration) : 0;
  }
}

double arrival_under_drag(double rate, double velocity, double pull, double distance) {
  if (pull == 0) return std::max(0.0, std::abs(velocity) - rate * distance);
  const double half = rate * distance / 2;
  const double square = (velocity - half) * (velocity - half) + 2 * pull * distance;
  if (!std::isfinite(square)) return std::abs(velocity);
  return std::max(0.0, std::sqrt(std::max(square, 0.0)) - half);
}

}  // namespace carom::effects
