#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "numbers/scalar.hpp"
#include "state/domain.hpp"

namespace carom::event {

/// The box in the numbers a run computes with; in double what Domain gives, to the last bit.
template <class S>
class SolverBox {
 public:
  explicit SolverBox(const Domain& domain) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      lower_[axis] = domain.lower[axis];
      upper_[axis] = domain.upper[axis];
      solid_[axis] = domain.solid(axis);
      periodic_[axis] = domain.period[axis] > 0;
      periods_[axis] = never<S>();
      if (periodic_[axis]) periods_[axis] = domain.period[axis];
      first_[axis] = periodic_[axis] ? lower_[axis] : S(-never<S>());
      last_[axis] = periodic_[axis] ? upper_[axis] : never<S>();
    }
  }

  [[nodiscard]] bool solid(std::size_t axis) const { return solid_[axis]; }
  [[nodiscard]] bool periodic(std::size_t axis) const { return periodic_[axis]; }
  /// Lengths of the axes, infinite where an axis is not periodic.
  [[nodiscard]] const std::array<S, 2>& periods() const { return periods_; }

  /// Where the centre of a ball may be between solid walls.
  [[nodiscard]] S lowest(std::size_t axis, const S& radius) const { return lower_[axis] + radius; }
  [[nodiscard]] S highest(std::size_t axis, const S& radius) const {
    const S low = lowest(axis, radius);
    const S high = upper_[axis] - radius;
    return high < low ? low : high;  // a ball as tall as its box, and rounding
  }

  /// The image of a place inside the box; mirrored places give mirrored images.
  [[nodiscard, gnu::always_inline]] inline Vec<S> wrapped(const Vec<S>& at) const {
    const bool inside =
        at.x >= first_[0] && at.x <= last_[0] && at.y >= first_[1] && at.y <= last_[1];
    return inside ? at : Vec<S>{wrapped(0, at.x), wrapped(1, at.y)};
  }

 private:
  [[nodiscard, gnu::noinline]] S wrapped(std::size_t axis, const S& x) const {
    using std::rint;
    if (!periodic_[axis] || (x >= lower_[axis] && x <= upper_[axis])) return x;
    const S centre = (lower_[axis] + upper_[axis]) / 2;
    const S image = x - periods_[axis] * rint(S((x - centre) / periods_[axis]));
    if (image < lower_[axis]) return lower_[axis];
    return image <= upper_[axis] ? image : upper_[axis];
  }

  std::array<S, 2> lower_;
  std::array<S, 2> upper_;
  std::array<S, 2> periods_;
  std::array<S, 2> first_;  ///< of the places that are inside; infinite unless the axis is periodic
  std::array<S, 2> last_;
  std::array<bool, 2> solid_{};
  std::array<bool, 2> periodic_{};
};

}  // namespace carom::event
