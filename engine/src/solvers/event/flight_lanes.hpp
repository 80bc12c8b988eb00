#pragma once

#include "contact/event_damped_law.hpp"
#include "contact/event_flight.hpp"
#include "solvers/event/lanes.hpp"

namespace carom::event {

/// Four balls as seen from a fifth, brought to the later start of each pair:
/// relative_at_later_start() with the same bits.
struct RelativeLanes {
  Lanes dx;
  Lanes dy;
  Lanes dvx;
  Lanes dvy;
};

/// What goes into it: the four flights, the fifth, and for each pair how long the earlier of the
/// two has flown at the start of the later one, and whether that is the fifth.
struct FlightLanes {
  Lanes x;
  Lanes y;
  Lanes vx;
  Lanes vy;
  Vec<double> place;
  Vec<double> velocity;
  Lanes elapsed;
  WholeLanes fifth_later;

  [[nodiscard]] RelativeLanes at_starts() const {
    return {x - place.x, y - place.y, vx - velocity.x, vy - velocity.y};
  }
};

inline RelativeLanes relative(const StraightLaw<double>&, const FlightLanes& f) {
  const Lanes zero{};
  RelativeLanes r = f.at_starts();
  r.dx = fused(f.fifth_later ? f.vx : zero - f.velocity.x, f.elapsed, r.dx);
  r.dy = fused(f.fifth_later ? f.vy : zero - f.velocity.y, f.elapsed, r.dy);
  return r;
}

inline RelativeLanes relative(const BallisticLaw<double>& law, const FlightLanes& f) {
  const Lanes zero{};
  const Lanes gx = zero + law.gravity.x;
  const Lanes gy = zero + law.gravity.y;
  const Lanes half = f.elapsed / 2;
  const WholeLanes later = f.fifth_later;
  const Lanes sx = fused(gx, half, later ? f.vx : zero + f.velocity.x) * f.elapsed;
  const Lanes sy = fused(gy, half, later ? f.vy : zero + f.velocity.y) * f.elapsed;
  RelativeLanes r = f.at_starts();
  r.dx = later ? r.dx + sx : r.dx - sx;
  r.dy = later ? r.dy + sy : r.dy - sy;
  r.dvx = later ? r.dvx + gx * f.elapsed : r.dvx - gx * f.elapsed;
  r.dvy = later ? r.dvy + gy * f.elapsed : r.dvy - gy * f.elapsed;
  return r;
}

struct DampingLanes {
  Lanes remaining;
  Lanes way;
  Lanes fall;
};

/// damping() of four times.
inline DampingLanes damping(Lanes x) {
  const Lanes zero{};
  Lanes fall = zero + kDampingCoefficients.of[kDampingTerms - 1];
  for (int n = kDampingTerms - 2; n >= 0; --n) {
    fall = fused(-x, fall, zero + kDampingCoefficients.of[n]);
  }
  Lanes way = fused(-x, fall, zero + 1);
  Lanes remaining = fused(-x, way, zero + 1);
  const WholeLanes far = x >= zero + kDampingSeries;
  if ((far[0] | far[1] | far[2] | far[3]) != 0) {
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      const Damping<double> d = event::damping(static_cast<double>(x[l]));
      remaining[l] = d.remaining;
      way[l] = d.way;
      fall[l] = d.fall;
    }
  }
  return {remaining, way, fall};
}

inline RelativeLanes relative(const DampedLaw<double>& law, const FlightLanes& f) {
  const Lanes zero{};
  const DampingLanes d = damping(f.elapsed * law.rate);
  const WholeLanes later = f.fifth_later;
  const Lanes vx = later ? f.vx : zero + f.velocity.x;
  const Lanes vy = later ? f.vy : zero + f.velocity.y;
  const Lanes pull_x = law.gravity.x * f.elapsed;
  const Lanes pull_y = law.gravity.y * f.elapsed;
  const Lanes sx = f.elapsed * fused(pull_x, d.fall, vx * d.way);
  const Lanes sy = f.elapsed * fused(pull_y, d.fall, vy * d.way);
  const Lanes then_x = fused(vx, d.remaining, pull_x * d.way);
  const Lanes then_y = fused(vy, d.remaining, pull_y * d.way);
  RelativeLanes r = f.at_starts();
  r.dx = later ? r.dx + sx : r.dx - sx;
  r.dy = later ? r.dy + sy : r.dy - sy;
  r.dvx = later ? then_x - f.velocity.x : f.vx - then_x;
  r.dvy = later ? then_y - f.velocity.y : f.vy - then_y;
  return r;
}

/// when() of four ways.
template <class Law>
Lanes when(const Law&, Lanes straight) {
  return straight;
}
inline Lanes when(const DampedLaw<double>& law, Lanes straight) {
  for (std::uint32_t l = 0; l < kLanes; ++l) {
    if (straight[l] < never<double>()) straight[l] = law.when(straight[l]);
  }
  return straight;
}

}  // namespace carom::event
