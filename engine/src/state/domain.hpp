#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "carom/scene.hpp"

namespace carom {

/// What each axis of the box does to a ball that comes to its ends.
struct Domain {
  enum class Sides { open, walls, periodic };

  std::array<double, 2> lower{0, 0};
  std::array<double, 2> upper{0, 0};
  std::array<double, 2> period{0, 0};  ///< the length of a periodic axis; 0: not periodic
  std::array<Sides, 2> sides{Sides::open, Sides::open};

  Domain(const Box& box, bool walls) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto k = axis;
      lower[axis] = box.lower()[k];
      upper[axis] = box.upper()[k];
      if (box.periodic[axis]) {
        sides[axis] = Sides::periodic;
        period[axis] = box.size()[k];
      } else if (walls) {
        sides[axis] = Sides::walls;
      }
    }
  }

  [[nodiscard]] bool solid(std::size_t axis) const { return sides[axis] == Sides::walls; }

  /// Where the centre of a ball may be between solid walls.
  [[nodiscard]] double lowest(std::size_t axis, double radius) const {
    return lower[axis] + radius;
  }
  [[nodiscard]] double highest(std::size_t axis, double radius) const {
    const double low = lowest(axis, radius);
    const double high = upper[axis] - radius;
    return high < low ? low : high;  // a ball as tall as its box, and rounding
  }

  /// The image of a coordinate inside the box; mirrored coordinates give mirrored images.
  [[nodiscard]] double wrapped(std::size_t axis, double x) const {
    if (x >= lower[axis] && x <= upper[axis]) return x;
    const double centre = (lower[axis] + upper[axis]) / 2;
    const double image = x - period[axis] * std::rint((x - centre) / period[axis]);
    if (image < lower[axis]) return lower[axis];
    return image <= upper[axis] ? image : upper[axis];
  }
};

/// The difference of two wrapped coordinates, the shorter way round an axis of length `period`, of
/// numbers of any kind or of several side by side; both are infinite on an axis that is not
/// periodic.
template <class Real>
inline Real nearest(Real difference, Real period, Real half) {
  return difference > half ? difference - period
                           : (difference < -half ? difference + period : difference);
}
/// The same on a periodic axis.
inline double nearest_image(double difference, double period) {
  return nearest(difference, period, period / 2);
}

/// From one wrapped place to another, the shorter way round every periodic axis.
inline Vec2 nearest_image(Vec2 difference, const Domain& domain) {
  for (std::size_t k = 0; k < 2; ++k) {
    const double period = domain.period[static_cast<std::size_t>(k)];
    if (period > 0) difference[k] = nearest_image(difference[k], period);
  }
  return difference;
}

}  // namespace carom
