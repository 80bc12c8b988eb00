#pragma once

#include <array>
#include <cstddef>

#include "state/domain.hpp"

namespace carom::event {

/// How far apart the balls are that move, and how fast, on average: what regions and windows are
/// measured by.
struct Spacing {
  double diameter = 0;
  double pitch = 0;  ///< between the centres of neighbours
  double gap = 0;    ///< between neighbours, at least a part of the pitch
  double speed = 0;  ///< of a ball, with what gravity adds on its way to the next one

  /// `speeds`: the squares, summed up; `diameters`: the sum.
  Spacing(std::size_t balls, double speeds, double diameters, const Domain& domain,
          const std::array<double, 2>& gravity);

  /// How far a ball flies before it meets another.
  [[nodiscard]] double way() const { return diameter > 0 ? gap * pitch / diameter : gap; }
  /// So much wider than what a ball's path sweeps its region is.
  [[nodiscard]] double margin(const std::array<double, 2>& periods) const;
};

}  // namespace carom::event
