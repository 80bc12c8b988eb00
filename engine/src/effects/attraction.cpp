#include "effects/attraction.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace carom::effects {
namespace {

constexpr std::size_t kLanes = 16;  // balls whose sums run side by side

using Lanes = std::array<double, kLanes>;

/// 1.5 2^exponent: 0 or infinite where that is no normal number.
double one_and_a_half(std::int64_t exponent) {
  const auto biased = exponent + 1023;
  if (biased <= 0) return 0;
  if (biased >= 2047) return std::numeric_limits<double>::infinity();
  return std::bit_cast<double>((biased << 52) | (std::int64_t{1} << 51));
}

/// A sum whose bits do not depend on the order of its terms.
///
/// Each term is cut at two fixed binary places into parts that add up without rounding.  The places
/// follow from the largest term and the number of terms.  What is dropped is less than 2^-80 of the
/// largest term for up to a million terms; nothing where the lower place is below normal numbers,
/// whose sums are exact.
/// Source: Demmel, Nguyen, IEEE Trans. Comput. 64 (2015) 2060.
class OrderlessCuts {
 public:
  /// REQUIRES: `largest` is the largest magnitude of `count` terms, and finite.
  OrderlessCuts(double largest, std::size_t count) {
    const std::int64_t exponent = (std::bit_cast<std::int64_t>(largest) >> 52) - 1022;
    const std::int64_t sum = exponent + static_cast<std::int64_t>(std::bit_width(count));
    upper = one_and_a_half(sum);
    lower = one_and_a_half(2 * sum - exponent - 52);
  }

  // Adding one of these and taking it away again rounds to its last place.
  double upper;
  double lower;
};

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
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<std::array<Lanes, 2>> terms(n);
  for (std::size_t start = begin; start < end; start += kLanes) {
    const std::size_t count = std::min(kLanes, end - start);
    Lanes at_x{};
    Lanes at_y{};
    for (std::size_t l = 0; l < kLanes; ++l) {
      at_x[l] = x[start + std::min(l, count - 1)];
      at_y[l] = y[start + std::min(l, count - 1)];
    }
    Lanes largest{};
    for (std::size_t j = 0; j < n; ++j) {
      const double m = mass[j];
      Lanes term_x{};
      Lanes term_y{};
      for (std::size_t l = 0; l < kLanes; ++l) {
        double dx = x[j] - at_x[l];
        double dy = y[j] - at_y[l];
        if constexpr (kPeriodicX) dx = nearest_image(dx, domain.period[0]);
        if constexpr (kPeriodicY) dy = nearest_image(dy, domain.period[1]);
        const double square = dx * dx + dy * dy + softening;
        // A ball does not attract itself, nor one in its very place.
        const double divisor = square > 0 ? square : infinity;
        const double weight = strength / (divisor * std::sqrt(divisor));
        term_x[l] = m * (weight * dx);
        term_y[l] = m * (weight * dy);
        const double size_x = std::abs(term_x[l]);
        const double size_y = std::abs(term_y[l]);
        const double size = size_x > size_y ? size_x : size_y;
        largest[l] = size > largest[l] ? size : largest[l];
      }
      terms[j] = {term_x, term_y};
    }
    Lanes upper{};
    Lanes lower{};
    for (std::size_t l = 0; l < kLanes; ++l) {
      const OrderlessCuts cuts(largest[l], n);
      upper[l] = cuts.upper;
      lower[l] = cuts.lower;
    }
    std::array<Lanes, 2> high{};
    std::array<Lanes, 2> low{};
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const Lanes& term = terms[j][axis];
        for (std::size_t l = 0; l < kLanes; ++l) {
          const double above = (term[l] + upper[l]) - upper[l];
          high[axis][l] += above;
          low[axis][l] += ((term[l] - above) + lower[l]) - lower[l];
        }
      }
    }
    for (std::size_t l = 0; l < count; ++l) {
      const bool moves = inverse_mass[start + l] > 0;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        balls.pull[axis][start + l] = moves ? high[axis][l] + low[axis][l] : 0;
      }
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

double strongest_pull(const Balls& balls) {
  double strongest = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (balls.fixed(i)) continue;
    strongest = std::max(strongest, Vec2{balls.pull[0][i], balls.pull[1][i]}.norm());
  }
  return strongest;
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
