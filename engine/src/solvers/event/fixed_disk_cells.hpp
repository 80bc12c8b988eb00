#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "carom/ball.hpp"
#include "geometry/cells.hpp"
#include "state/domain.hpp"

namespace carom::event {

/// The fixed balls by the cells of the plane that each is in, wholly or in part: finds those near
/// to a ball without looking at all of them.
///
/// Holds: balls and fixed ones of any sizes; a large one is in many cells.
class FixedDiskCells {
 public:
  /// REQUIRES: `balls` lasts as long as this.
  FixedDiskCells(const Domain& domain, const std::vector<Ball>& balls)
      : domain_(domain), balls_(balls) {
    std::array<double, 2> size{};
    for (std::size_t axis = 0; axis < 2; ++axis)
      size[axis] = domain.upper[axis] - domain.lower[axis];
    const double side = std::sqrt(size[0] * size[1] / static_cast<double>(balls.size() + 1));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      count_[axis] = std::clamp(std::floor(size[axis] / side), 1.0, kMost);
      per_length_[axis] = count_[axis] / size[axis];
    }
    struct Entry {
      std::size_t cell;
      std::uint32_t ball;
    };
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      if (!balls[i].fixed) continue;
      each_cell(balls[i], [&](std::size_t cell) {
        entries.push_back({cell, static_cast<std::uint32_t>(i)});
        return false;
      });
    }
    if (entries.empty()) return;
    order_.resize(entries.size());
    by_cell_.sort(
        static_cast<std::size_t>(count_[0] * count_[1]), entries.size(),
        [&](std::size_t k) { return static_cast<std::uint32_t>(entries[k].cell); },
        [&](std::size_t k, std::uint32_t place) { order_[place] = entries[k].ball; });
  }

  /// Whether `is(fixed)` holds of any fixed ball that touches this one; it is asked of others near
  /// to it, too.
  template <class Is>
  [[nodiscard]] bool any_near(const Ball& ball, const Is& is) const {
    return !order_.empty() && each_cell(ball, [&](std::size_t cell) {
      return std::any_of(order_.begin() + by_cell_.begin(cell), order_.begin() + by_cell_.end(cell),
                         [&](std::uint32_t fixed) { return is(balls_[fixed]); });
    });
  }

 private:
  static constexpr double kMost = 20000;         // cells along an axis
  static constexpr double kWider = 1 + 0x1p-10;  // more than balls that touch may be apart
  static constexpr double kRounding = 0x1p-40;   // of the box

  // Of the cells that a square around the ball meets, until `visit` is true; whether it was.
  template <class Visit>
  bool each_cell(const Ball& ball, const Visit& visit) const {
    std::array<std::int64_t, 2> first{};
    std::array<std::int64_t, 2> last{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double size = domain_.upper[axis] - domain_.lower[axis];
      const bool round = domain_.period[axis] > 0;
      double from_lower = ball.position[axis] - domain_.lower[axis];
      if (round) from_lower -= size * std::floor(from_lower / size);
      const double reach = ball.radius * kWider + kRounding * size;
      const double most = round ? 2 * count_[axis] : count_[axis] - 1;
      const double least = round ? -count_[axis] : 0;
      const auto at = [&](double x) {
        return static_cast<std::int64_t>(
            std::clamp(std::floor(x * per_length_[axis]), least, most));
      };
      first[axis] = at(from_lower - reach);
      last[axis] = at(from_lower + reach);
      // All around, each once.
      last[axis] = std::min(last[axis], first[axis] + static_cast<std::int64_t>(count_[axis]) - 1);
    }
    const auto columns = static_cast<std::int64_t>(count_[0]);
    const auto rows = static_cast<std::int64_t>(count_[1]);
    for (std::int64_t y = first[1]; y <= last[1]; ++y) {
      const std::int64_t row = (y + rows) % rows * columns;
      for (std::int64_t x = first[0]; x <= last[0]; ++x) {
        if (visit(static_cast<std::size_t>(row + (x + columns) % columns))) return true;
      }
    }
    return false;
  }

  Domain domain_;
  const std::vector<Ball>& balls_;
  std::array<double, 2> count_{1, 1};  ///< of cells
  std::array<double, 2> per_length_{1, 1};
  ByCell by_cell_;
  std::vector<std::uint32_t> order_;  ///< the fixed balls of each cell
};

}  // namespace carom::event
