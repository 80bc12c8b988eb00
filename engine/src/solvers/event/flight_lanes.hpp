#pragma once

#include "solvers/event/lanes.hpp"
#include "trajectory/damped_law.hpp"
#include "trajectory/flight.hpp"

namespace carom::event {

/// Four balls as seen from a fifth, brought to the later start of each pair:
/// relative_at_later_start() with the same bits.
struct RelativeLanes {
  Lanes dx;
  Lanes dy;
  Lanes dvx;
  Lanes dvy;
};

/// What goes into it: the four flights, the fifth, and for each pair how much later the fifth has
/// started; negative: earlier.
struct FlightLanes {
  Lanes x;
  Lanes y;
  Lanes vx;
  Lanes vy;
  Vec<double> place;
  Vec<double> velocity;
  Lanes since;

  [[nodiscard]] RelativeLanes at_starts() const {
    return {x - place.x, y - place.y, vx - velocity.x, vy - velocity.y};
  }
  /// The velocities of those that started earlier.
  [[nodiscard]] Lanes earlier_vx() const { return since > Lanes{} ? vx : all(velocity.x); }
  [[nodiscard]] Lanes earlier_vy() const { return since > Lanes{} ? vy : all(velocity.y); }
};

[[gnu::always_inline]] inline RelativeLanes relative(const StraightLaw<double>&,
                                                     const FlightLanes& f) {
  RelativeLanes r = f.at_starts();
  r.dx = fused(f.earlier_vx(), f.since, r.dx);
  r.dy = fused(f.earlier_vy(), f.since, r.dy);
  return r;
}

[[gnu::always_inline]] inline RelativeLanes relative(const BallisticLaw<double>& law,
                                                     const FlightLanes& f) {
  const Lanes elapsed = absolute(f.since);
  Lanes mean_x = f.earlier_vx();
  Lanes mean_y = f.earlier_vy();
  RelativeLanes r = f.at_starts();
  if (law.gravity.x != 0) {  // asked once for all the balls: it mostly falls straight down
    mean_x = fused(all(law.gravity.x / 2), elapsed, mean_x);
    r.dvx = fused(all(law.gravity.x), f.since, r.dvx);
  }
  if (law.gravity.y != 0) {
    mean_y = fused(all(law.gravity.y / 2), elapsed, mean_y);
    r.dvy = fused(all(law.gravity.y), f.since, r.dvy);
  }
  r.dx = fused(mean_x, f.since, r.dx);
  r.dy = fused(mean_y, f.since, r.dy);
  return r;
}

struct DampingLanes {
  Lanes remaining;
  Lanes way;
  Lanes fall;
};

/// damping() of four times.
[[gnu::always_inline]] inline DampingLanes damping(Lanes x) {
  Lanes fall = damping_series(
      x, [](double a) __attribute__((always_inline)) { return all(a); },
      [](Lanes a, Lanes b, Lanes c) __attribute__((always_inline)) { return fused(a, b, c); });
  Lanes way = fused(-x, fall, all(1.0));
  Lanes remaining = fused(-x, way, all(1.0));
  const WholeLanes far = x >= all(kDampingSeries);
  if (any(far)) {
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      if (far[l] == 0) continue;
      const Damping<double> d = event::damping(static_cast<double>(x[l]));
      remaining[l] = d.remaining;
      way[l] = d.way;
      fall[l] = d.fall;
    }
  }
  return {remaining, way, fall};
}

[[gnu::always_inline]] inline RelativeLanes relative(const DampedLaw<double>& law,
                                                     const FlightLanes& f) {
  const Lanes zero{};
  const WholeLanes later = f.since > zero;
  const Lanes elapsed = absolute(f.since);
  const DampingLanes d = damping(elapsed * law.rate);
  const Lanes vx = f.earlier_vx();
  const Lanes vy = f.earlier_vy();
  Lanes mean_x = vx * d.way;
  Lanes mean_y = vy * d.way;
  Lanes then_x = vx * d.remaining;
  Lanes then_y = vy * d.remaining;
  if (law.gravity.x != 0 || law.gravity.y != 0) {
    const Lanes pull_x = law.gravity.x * elapsed;
    const Lanes pull_y = law.gravity.y * elapsed;
    mean_x = fused(pull_x, d.fall, mean_x);
    mean_y = fused(pull_y, d.fall, mean_y);
    then_x = fused(vx, d.remaining, pull_x * d.way);
    then_y = fused(vy, d.remaining, pull_y * d.way);
  }
  RelativeLanes r = f.at_starts();
  r.dx += f.since * mean_x;
  r.dy += f.since * mean_y;
  r.dvx = later ? then_x - f.velocity.x : f.vx - then_x;
  r.dvy = later ? then_y - f.velocity.y : f.vy - then_y;
  return r;
}

/// when() of four ways: of the `wanted` lanes, the others may hold anything not before it.
template <class Law>
Lanes when(const Law&, Lanes straight, WholeLanes) {
  return straight;
}
[[gnu::always_inline]] inline Lanes when(const DampedLaw<double>& law, Lanes straight,
                                         WholeLanes wanted) {
  for (std::uint32_t l = 0; l < kLanes; ++l) {
    straight[l] = wanted[l] != 0 ? law.when(straight[l]) : never<double>();
  }
  return straight;
}

}  // namespace carom::event
