#pragma once

#include <cstddef>

#include "solvers/event/disk.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

/// Moves a place of the ball onto a wall, where touching leaves it.  Gives the energy that the
/// change of its height takes.
template <class P>
double put_on_wall(const Motion<P>& motion, const typename P::Disk& disk, Index wall,
                   Vec<typename P::Scalar>& at) {
  using S = typename P::Scalar;
  const std::size_t axis = (wall - kWalls) / 2;
  const S stop = motion.wall(disk, at, wall).stop;
  S& x = axis == 0 ? at.x : at.y;
  const S lifted = (x - stop) * motion.law().pull(axis) / motion.species(disk).inverse_mass;
  x = stop;
  return static_cast<double>(lifted);
}

}  // namespace carom::event
