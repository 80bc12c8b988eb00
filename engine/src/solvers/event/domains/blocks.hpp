#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "state/domain.hpp"

namespace carom::event {

/// The plane in square blocks of some ten balls, by which flights are kept in order.
///
/// Balls beyond an end of an axis that is not periodic are in its outermost blocks.
class Blocks {
 public:
  Blocks(const Domain& domain, std::size_t balls) : lower_(domain.lower) {
    constexpr double kBallsOfBlock = 10;
    const double area = (domain.upper[0] - domain.lower[0]) * (domain.upper[1] - domain.lower[1]);
    const double side =
        std::sqrt(area * kBallsOfBlock / static_cast<double>(std::max<std::size_t>(balls, 1)));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double length = domain.upper[axis] - domain.lower[axis];
      periodic_[axis] = domain.period[axis] > 0;
      count_[axis] = static_cast<int>(std::clamp(length / side, 1.0, 20000.0));
      per_length_[axis] = 1 / length;
      side_[axis] = length / count_[axis];
    }
  }

  [[nodiscard]] int count(std::size_t axis) const { return count_[axis]; }
  [[nodiscard]] std::size_t all() const {
    return static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]);
  }
  [[nodiscard]] double side(std::size_t axis) const { return side_[axis]; }
  [[nodiscard]] double lower(std::size_t axis) const { return lower_[axis]; }
  [[nodiscard]] bool periodic(std::size_t axis) const { return periodic_[axis]; }

  [[nodiscard]] std::uint32_t at(double x, double y) const {
    return static_cast<std::uint32_t>(along(1, y) * count_[0] + along(0, x));
  }

 private:
  [[nodiscard]] int along(std::size_t axis, double x) const {
    double part = (x - lower_[axis]) * per_length_[axis];
    if (periodic_[axis]) part -= std::floor(part);
    return static_cast<int>(std::clamp(part * count_[axis], 0.0, count_[axis] - 1.0));
  }

  std::array<double, 2> lower_;
  std::array<bool, 2> periodic_{};
  std::array<int, 2> count_{1, 1};
  std::array<double, 2> per_length_{1, 1};
  std::array<double, 2> side_{1, 1};
};

/// A rectangle of blocks.
struct BlockRange {
  std::array<int, 2> first{0, 0};
  std::array<int, 2> size{0, 0};
};

/// All blocks in about so many rectangles, as near to squares of one size as there are blocks for.
[[nodiscard]] std::vector<BlockRange> cut(const Blocks& blocks, std::size_t wanted);

}  // namespace carom::event
