#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "solvers/event/lanes.hpp"
#include "state/domain.hpp"

namespace carom::event {

/// The piece of the plane that a tile's balls are in, and how many it must have room for.
///
/// A ball may leave it: it is then looked for at the rim, which costs time, not correctness.
struct Plot {
  std::array<double, 2> lower{0, 0};
  std::array<double, 2> upper{1, 1};
  std::array<bool, 2> whole{true, true};  ///< all of the domain along this axis
  std::size_t slots = 0;

  Plot() = default;
  explicit Plot(const Domain& domain) : lower(domain.lower), upper(domain.upper) {}

  [[nodiscard]] double length(std::size_t axis) const { return upper[axis] - lower[axis]; }
  [[nodiscard]] double area() const { return length(0) * length(1); }
  /// From the lower end to x, in the nearest image where the axis is cut off.
  [[nodiscard]] double along(double x, std::size_t axis, double period) const {
    if (whole[axis]) return x - lower[axis];
    const double half = length(axis) / 2;
    return nearest(x - (lower[axis] + half), period, period / 2) + half;
  }
};

}  // namespace carom::event
