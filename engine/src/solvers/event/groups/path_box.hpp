#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "solvers/event/groups/path.hpp"
#include "solvers/event/groups/region_pairs.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

/// Where the centre of a fixed ball is.
template <class P>
Bounds box_of_fixed(const typename P::Disk& disk) {
  return {{static_cast<double>(disk.x), static_cast<double>(disk.y)}, {0, 0}};
}

/// What the centre of a ball sweeps on a path from `now` to `until`: from each flight's start to
/// its end, and as far beside the chord as the flight can bend.
template <class P>
Bounds box_of_path(const Motion<P>& motion, const typename Paths<P>::Path& path, typename P::At now,
                   typename P::At until) {
  using S = typename P::Scalar;
  using Time = typename P::Time;
  const Domain& domain = motion.rules().domain;
  std::array<double, 2> low{};
  std::array<double, 2> high{};
  std::array<double, 2> shift{0, 0};  // of the image that a flight is in
  std::array<double, 2> last{};
  for (std::size_t k = 0; k < path.size(); ++k) {
    const typename P::Disk& disk = path[k].flight;
    const Time from = k == 0 ? Time(now) : disk.start;
    const Time to = k + 1 < path.size() ? path[k + 1].flight.start : Time(until);
    const Flight<S> begins = motion.at(disk, from);
    const Vec<S> ends = motion.place(disk, to);
    const auto span = static_cast<double>(motion.rules().scale.seconds(to - from));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const S& v = axis == 0 ? begins.velocity.x : begins.velocity.y;
      auto at = static_cast<double>(axis == 0 ? begins.position.x : begins.position.y);
      const auto end = static_cast<double>(axis == 0 ? ends.x : ends.y);
      const double way = end - at;
      if (k > 0 && domain.period[axis] > 0) {
        shift[axis] = domain.period[axis] * std::rint((last[axis] - at) / domain.period[axis]);
      }
      at += shift[axis];
      last[axis] = at + way;
      const double bend =
          std::abs(static_cast<double>(S(motion.law_of(disk).push(axis, v)))) * span * span / 8;
      const double lowest = std::min(at, last[axis]) - bend;
      const double highest = std::max(at, last[axis]) + bend;
      low[axis] = k == 0 ? lowest : std::min(low[axis], lowest);
      high[axis] = k == 0 ? highest : std::max(high[axis], highest);
    }
  }
  Bounds box;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double length = domain.upper[axis] - domain.lower[axis];
    box.centre[axis] = low[axis] + (high[axis] - low[axis]) / 2;
    box.half[axis] = (high[axis] - low[axis]) / 2 * (1 + 0x1p-20) +
                     (length + std::abs(low[axis]) + std::abs(high[axis])) * 0x1p-44;
  }
  return box;
}

}  // namespace carom::event
