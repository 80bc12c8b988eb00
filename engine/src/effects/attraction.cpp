#include "effects/attraction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom::effects {
namespace {

constexpr std::size_t kLanes = 16;  // balls whose sums run side by side

template <bool kPeriodicX, bool kPeriodicY>
void attract_lanes(Balls& balls, const Domain& domain, const Attraction& attraction,
                   std::size_t begin, std::size_t end) {
  const double* x = balls.position[0].data();
  const double* y = balls.position[1].data();
  const double* mass = balls.mass.data();
  const double* inverse_mass = balls.inverse_mass.data();
  const std::size_t n = balls.size();
  const double softening = attraction.softening * attraction.softening;
  const double strength = attraction.strength;
  std::array<double, kLanes> at_x{};
  std::array<double, kLanes> at_y{};
  for (std::size_t start = begin; start < end; start += kLanes) {
    const std::size_t count = std::min(kLanes, end - start);
    for (std::size_t l = 0; l < kLanes; ++l) {
      at_x[l] = x[start + std::min(l, count - 1)];
      at_y[l] = y[start + std::min(l, count - 1)];
    }
    alignas(64) std::array<double, kLanes> sum_x{};
    alignas(64) std::array<double, kLanes> sum_y{};
    for (std::size_t j = 0; j < n; ++j) {
      const double m = mass[j];
      for (std::size_t l = 0; l < kLanes; ++l) {
        double dx = x[j] - at_x[l];
        double dy = y[j] - at_y[l];
        if constexpr (kPeriodicX) dx = nearest_image(dx, domain.period[0]);
        if constexpr (kPeriodicY) dy = nearest_image(dy, domain.period[1]);
        const double square = dx * dx + dy * dy + softening;
        const double part = strength / (square * std::sqrt(square));
        // A ball does not attract itself, nor one in its very place.
        const double weight = square > 0 ? part : 0;
        sum_x[l] += m * (weight * dx);
        sum_y[l] += m * (weight * dy);
      }
    }
    for (std::size_t l = 0; l < count; ++l) {
      const bool moves = inverse_mass[start + l] > 0;
      const std::size_t i = start + l;
      balls.pull[0][i] = moves ? sum_x[l] : 0;
      balls.pull[1][i] = moves ? sum_y[l] : 0;
    }
  }
}

double apart(const Balls& balls, const Domain& domain, std::size_t axis, std::size_t i,
             std::size_t j) {
  const double d = balls.position[axis][j] - balls.position[axis][i];
  return domain.period[axis] > 0 ? nearest_image(d, domain.period[axis]) : d;
}

}  // namespace

void attract(Balls& balls, const Domain& domain, const Attraction& attraction, std::size_t begin,
             std::size_t end) {
  const bool x = domain.period[0] > 0;
  const bool y = domain.period[1] > 0;
  if (x && y) return attract_lanes<true, true>(balls, domain, attraction, begin, end);
  if (x) return attract_lanes<true, false>(balls, domain, attraction, begin, end);
  if (y) return attract_lanes<false, true>(balls, domain, attraction, begin, end);
  attract_lanes<false, false>(balls, domain, attraction, begin, end);
}

void kick(Balls& balls, double seconds, std::size_t begin, std::size_t end) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double* velocity = balls.velocity[axis].data();
    const double* pull = balls.pull[axis].data();
    for (std::size_t i = begin; i < end; ++i) velocity[i] += pull[i] * seconds;
  }
}

double attraction_energy(const Balls& balls, const Domain& domain, const Attraction& attraction) {
  if (attraction.strength == 0) return 0;
  const double softening = attraction.softening * attraction.softening;
  double sum = 0;
  for (std::size_t i = 0; i < balls.mass.size(); ++i) {
    double potential = 0;
    for (std::size_t j = 0; j < i; ++j) {
      if (balls.inverse_mass[i] == 0 && balls.inverse_mass[j] == 0) continue;
      const double dx = apart(balls, domain, 0, i, j);
      const double dy = apart(balls, domain, 1, i, j);
      const double square = dx * dx + dy * dy + softening;
      if (square > 0) potential += balls.mass[j] / std::sqrt(square);
    }
    sum -= attraction.strength * balls.mass[i] * potential;
  }
  return sum;
}

}  // namespace carom::effects
