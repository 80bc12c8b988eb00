#pragma once

#include <limits>

#include "contact/rest_rules.hpp"
#include "numbers/scalar.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

// Whether a ball approaches what it meets by more than the rounding of its speed.

template <class S>
S noise_of(const Vec<S>& v) {
  return kRounding * std::numeric_limits<S>::epsilon() * S(absolute(v.x) + absolute(v.y));
}

template <class P>
bool nears_wall(const Motion<P>& motion, const typename P::Disk& disk, Index wall,
                typename P::At now) {
  using S = typename P::Scalar;
  const Vec<S> v = motion.velocity(disk, now);
  const S& speed = wall - kWalls < 2 ? v.x : v.y;
  return (wall % 2 == kWalls % 2 ? S(-speed) : speed) > noise_of(v);
}

template <class P>
bool nears_ball(const Motion<P>& motion, const typename P::Disk& one, const typename P::Disk& other,
                typename P::At now) {
  using S = typename P::Scalar;
  const Vec<S> mine = motion.velocity(one, now);
  const Vec<S> its = motion.velocity(other, now);
  const Vec<S> r = motion.way(motion.place(one, now), motion.place(other, now));
  const S approach = -sharp_dot(r, its - mine) / root(S(r.x * r.x + r.y * r.y));
  return approach > noise_of(mine) + noise_of(its);
}

}  // namespace carom::event
