#pragma once

#include <algorithm>
#include <cstdint>

#include "solvers/event/event_costs.hpp"
#include "solvers/event/motion.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

/// What happens between two readings of the clock that have nothing between them is theirs.
template <class Work>
double seconds_of(const Work& work) {
  double clock = 0;
  double seconds = 0;
  { const Stopwatch stopwatch(true, clock); }
  {
    const Stopwatch stopwatch(true, seconds);
    work();
  }
  return std::max(0.0, seconds - clock);
}

/// Makes the compiler work out what is not used.
template <class Value>
void use(const Value& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// An event of a ball: as it was before, with what, and as the ball flies on.
template <class P>
struct TimedEvent {
  using Disk = typename P::Disk;
  using S = typename P::Scalar;
  Disk before;
  Index partner = kUnknown;
  Disk other_before;  ///< where the partner is a ball
  S spin = 0;
  S other_spin = 0;
  Disk after;
  typename P::Time until = P::Clock::never();  ///< the next event
  bool spins = false;                          ///< balls have friction
};

/// What is not the pairs' in an event is small, and mixed with it in the code: it is done once
/// more, on copies, and timed alone.
template <class P>
[[gnu::noinline]] Costs costs_beside_pairs(const Motion<P>& motion, TimedEvent<P> event,
                                           typename P::At now) {
  using S = typename P::Scalar;
  const bool at_wall = event.partner >= kWalls;
  const bool at_ball = event.partner < kFirstMark;
  const bool both = at_ball && !motion.fixed(event.other_before);
  Costs costs;
  if (motion.bends()) {
    const double flight = seconds_of([&] { use(motion.at(event.before, now)); });
    if (event.partner != kUnknown) costs.bending = both ? 2 * flight : flight;
  }
  if (motion.box().solid(0) || motion.box().solid(1)) {
    const double search = seconds_of([&] { use(motion.alone(event.after, event.until)); });
    costs.walls = both ? 2 * search : search;
  }
  if (at_wall) {
    auto disk = event.before;
    const double impact = seconds_of([&] {
      S turning = event.spin;
      motion.bounce(disk, event.spins ? &turning : nullptr, event.partner, now);
      use(disk);
    });
    costs.walls += std::max(0.0, impact - costs.bending);
  }
  if (!event.spins) return costs;
  auto disk = event.before;
  auto other = event.other_before;
  if (at_wall) {
    motion.carry(disk, now);
    const std::size_t axis = (event.partner - kWalls) / 2;
    const int side = (event.partner - kWalls) % 2 == 0 ? 1 : -1;
    const S arrival = side * (axis == 0 ? disk.vx : disk.vy);
    costs.friction = seconds_of([&] {
      motion.apply_wall_friction(disk, event.spin, axis, side, arrival);
      use(disk);
    });
    costs.walls = std::max(0.0, costs.walls - costs.friction);
  } else if (at_ball) {
    motion.carry(disk, now);
    if (both) motion.carry(other, now);
    const Vec<S> r = motion.way({disk.x, disk.y}, {other.x, other.y});
    costs.friction = seconds_of([&] {
      motion.apply_friction(disk, event.spin, other, event.other_spin, r);
      use(disk);
      use(other);
    });
  }
  return costs;
}

}  // namespace carom::event
