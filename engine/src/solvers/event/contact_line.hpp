#pragma once

#include <cstddef>
#include <utility>

#include "carom/impact.hpp"
#include "contact/impact_log.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

// Flights as lines of a log, but for what a contact carries.

/// A ball at rest that moves again from now on.
inline Impact wake_line(const Vec<double>& at, std::size_t i, double seconds) {
  Impact line;
  line.time = seconds;
  line.kind = ImpactKind::wake;
  line.a = i;
  line.position = {at.x, at.y};
  return line;
}

/// A slide along a wall as a contact that does not bounce; `at`: where ball i is then.
template <class P>
Impact slide_line(const typename Motion<P>::Slide& slide, const Vec<double>& at, std::size_t i,
                  double seconds, double radius) {
  const std::size_t axis = (slide.wall - kWalls) / 2;
  const bool upper = (slide.wall - kWalls) % 2 == 1;
  Impact line;
  line.time = seconds;
  line.kind = ImpactKind::rest;
  line.a = i;
  line.wall = side_of(axis, upper);
  line.position = {at.x, at.y};
  line.normal[axis] = upper ? 1 : -1;
  line.distance = radius;
  line.impulse = slide.impulse;
  line.tangential = slide.tangential;
  line.energy_lost = slide.lost;
  return line;
}

/// A contact of ball i with ball j, or with a wall, r away; `disks`: the flights of all balls.
template <class P, class Disks>
Impact contact_line(const Motion<P>& motion, const Disks& disks, Index i, Index j,
                    Vec<typename P::Scalar> r, typename P::At now) {
  using S = typename P::Scalar;
  if (j < i) {
    std::swap(i, j);
    r = -r;
  }
  const S length = root(S(r.x * r.x + r.y * r.y));
  const Vec<S> at = motion.wrapped(motion.place(disks[i], now));
  Impact line;
  line.time = static_cast<double>(motion.rules().scale.seconds(now));
  line.a = i;
  line.position = {static_cast<double>(at.x), static_cast<double>(at.y)};
  // No component is -0.
  line.normal = {static_cast<double>(S(r.x / length)) + 0.0,
                 static_cast<double>(S(r.y / length)) + 0.0};
  if (j >= kWalls) {
    line.kind = ImpactKind::wall;
    line.wall = side_of((j - kWalls) / 2, (j - kWalls) % 2 == 1);
    line.distance = static_cast<double>(motion.species(disks[i]).radius);
  } else {
    line.b = j;
    line.distance = static_cast<double>(length);
  }
  return line;
}

}  // namespace carom::event
