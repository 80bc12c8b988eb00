#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "solvers/event/domains/domain_loop.hpp"
#include "solvers/event/exit_lanes.hpp"

namespace carom::event {

/// How far the middle of a circle is ahead of the ball, as a part of its radius.
inline constexpr double kCircleAhead = 0.4;

// The flight has just begun.
template <class P>
[[gnu::always_inline]] inline void DomainLoop<P>::fly_on(Slot i, FixedTime now) {
  const BlockFlight& disk = flights_[i];
  Side& side = sides_[i];
  if (++side.changes == 0) unusual_ = true;  // so many are counted
  Path& path = paths_[i];
  const double dx = disk.x - window_.middle[0] - side.x;
  const double dy = disk.y - window_.middle[1] - side.y;
  const double shift_x = window_.middle[0] + periods_[0] * std::rint(dx * per_period_[0]);
  const double shift_y = window_.middle[1] + periods_[1] * std::rint(dy * per_period_[1]);
  if (tracked_) {
    note_change(i, now);
    note_place(i, disk.x - shift_x, disk.y - shift_y);
  }
  if constexpr (!P::Law::kStretches) {
    const double since = seconds(now);
    if (!bends_) {
      path = {disk.x - shift_x - since * disk.vx, disk.y - shift_y - since * disk.vy, disk.vx,
              disk.vy};
    } else {
      const Vec<double>& g = motion_.law().pull();
      path = {disk.x - shift_x - since * (disk.vx - g.x * (since / 2)),
              disk.y - shift_y - since * (disk.vy - g.y * (since / 2)), disk.vx - g.x * since,
              disk.vy - g.y * since};
    }
  } else {
    const Vec<double> at = motion_.place(disk, window_.from);
    const Vec<double> v = motion_.velocity(disk, window_.from);
    path = {at.x - shift_x, at.y - shift_y, v.x, v.y};
  }
  side.leaves = exit(i, now);
  side.set(kFar, !(std::abs(disk.vx) < slow_[0] && std::abs(disk.vy) < slow_[1]));
}

template <class P>
[[gnu::always_inline]] inline void DomainLoop<P>::note_change(Slot i, FixedTime now) {
  const BlockFlight& flight = flights_[i];
  std::uint64_t& history = tracks_[i].history;
  const auto mix = [&](std::uint64_t bits) {
    history = (history ^ bits) * 0x9e3779b97f4a7c15U;
    history ^= history >> 32;
  };
  mix(static_cast<std::uint64_t>(now) ^ (std::bit_cast<std::uint64_t>(flight.vx) << 1));
  mix(std::bit_cast<std::uint64_t>(flight.vy));
  if (!spins_.empty()) mix(std::bit_cast<std::uint64_t>(spins_[i]));
}

// Straight flights are farthest from anywhere where they begin or end.
template <class P>
[[gnu::always_inline]] inline void DomainLoop<P>::note_place(std::size_t i, double x, double y) {
  Track& track = tracks_[i];
  const float dx = static_cast<float>(x) - track.x;
  const float dy = static_cast<float>(y) - track.y;
  track.square = std::max(track.square, dx * dx + dy * dy);
}

template <class P>
Vec<double> DomainLoop<P>::last_place(std::size_t k) const {
  if (sides_[k].fixed) return {paths_[k].x, paths_[k].y};
  return place(static_cast<Slot>(k), window_.until);
}

// What gravity bends a flight by adds to the places that were noted.
template <class P>
float DomainLoop<P>::displacement(std::size_t k, const Vec<double>& last) {
  if (sides_[k].fixed) return 0;
  note_place(k, last.x, last.y);
  return static_cast<float>((std::sqrt(static_cast<double>(tracks_[k].square)) + bend_) *
                            (1 + 0x1p-16));
}

// Where the ball is, in the image that its path is in.
template <class P>
Vec<double> DomainLoop<P>::place(Slot i, FixedTime now) const {
  const Path& path = paths_[i];
  if constexpr (!P::Law::kStretches) {
    const double since = seconds(now);
    const Vec<double>& g = motion_.law().pull();
    return {path.x + since * (path.vx + g.x * (since / 2)),
            path.y + since * (path.vy + g.y * (since / 2))};
  } else {
    const Vec<double> then = motion_.place(flights_[i], window_.from);
    const Vec<double> at = motion_.place(flights_[i], now);
    return {path.x + (at.x - then.x), path.y + (at.y - then.y)};
  }
}

template <class P>
Vec<double> DomainLoop<P>::velocity(Slot i, FixedTime now) const {
  if constexpr (!P::Law::kStretches) {
    const Path& path = paths_[i];
    const double since = seconds(now);
    const Vec<double>& g = motion_.law().pull();
    return {path.vx + g.x * since, path.vy + g.y * since};
  } else {
    return motion_.velocity(flights_[i], now);
  }
}

// Its circle lies ahead of the ball, the way it flies.
template <class P>
[[gnu::always_inline]] inline Vec<double> DomainLoop<P>::ahead(const Vec<double>& v) const {
  const double square = v.x * v.x + v.y * v.y;
  if (!(square > 0)) return {0, 0};
  const double by = kCircleAhead * window_.skin / std::sqrt(square);
  return {by * v.x, by * v.y};
}

template <class P>
void DomainLoop<P>::choose_circle(Slot i, FixedTime now) {
  const Vec<double> at = place(i, now);
  const Vec<double> shift = ahead(velocity(i, now));
  Side& side = sides_[i];
  side.x = static_cast<float>(at.x + shift.x);
  side.y = static_cast<float>(at.y + shift.y);
  note_ends(i);
  side.leaves = exit(i, now);
  note_walls(i);
}

// Of axes that wrap: the middle of its circle is kept between them, so that two circles that are
// not by an end are near to each other in these images, or in none.
template <class P>
[[gnu::always_inline]] inline void DomainLoop<P>::note_ends(Slot i) {
  Side& side = sides_[i];
  side.by_end = tracked_;
  if (tracked_) return;  // its displacement is measured in one image
  const auto note = [&](std::size_t axis, float& middle, double& path) {
    if (!window_.wraps[axis]) return;
    const double shift = periods_[axis] * std::rint(middle * per_period_[axis]);
    if (shift != 0) {
      middle = static_cast<float>(middle - shift);
      path -= shift;
    }
    if (!(std::abs(middle) < inside_[axis])) side.by_end = true;
  };
  note(0, side.x, paths_[i].x);
  note(1, side.y, paths_[i].y);
}

// Its circle, its radius taken off the room it has.
template <class P>
[[gnu::always_inline]] inline void DomainLoop<P>::note_walls(Slot i) {
  if (!walls_) return;
  Side& side = sides_[i];
  const double reach = (window_.skin + radius(i)) * (1 + 0x1p-20);
  const auto clear = [&](std::size_t axis, double x) {
    return !motion_.box().solid(axis) ||
           (x - reach > window_.lowest[axis] && x + reach < window_.highest[axis]);
  };
  side.set(kAtWall, !clear(0, side.x) || !clear(1, side.y));
}

// Seconds until a place at `off` that moves straight at v is `radius` from 0.
[[gnu::always_inline]] inline double leaves_circle(const Vec<double>& off, const Vec<double>& v,
                                                   double radius) {
  const double square = v.x * v.x + v.y * v.y;
  if (!(square > 0)) return never<double>();
  const double along = off.x * v.x + off.y * v.y;
  const double gap = radius * radius - off.x * off.x - off.y * off.y;
  return (std::sqrt(std::max(0.0, along * along + square * gap)) - along) / square;
}

// Not before it is `skin` from the middle of its circle.
template <class P>
[[gnu::always_inline]] inline double DomainLoop<P>::exit(Slot i, FixedTime now) const {
  const Side& side = sides_[i];
  if (!bends_) {
    const Path& path = paths_[i];
    const Vec<double> off{path.x - side.x, path.y - side.y};
    if (tracked_) {
      // In a window that is so short most are still in it at the end.
      const Vec<double> last{off.x + end_ * path.vx, off.y + end_ * path.vy};
      if (last.x * last.x + last.y * last.y < skin_square_) return never<double>();
    }
    return leaves_circle(off, {path.vx, path.vy}, window_.skin);
  }
  const Vec<double> at = place(i, now);
  const Vec<double> off{at.x - side.x, at.y - side.y};
  const Vec<double> v = velocity(i, now);
  const double since = seconds(now);
  // Till the end of the window it is never farther than so much from straight flight.
  const double rest = end_ - since;
  double bend = bend_per_square_ * rest * rest;
  if constexpr (P::Law::kStretches) {
    bend += motion_.law().rate * std::hypot(v.x, v.y) * rest * rest / 2;
  }
  if (bend < window_.skin / 4) {
    const double radius = (window_.skin - bend) * (1 - 0x1p-20);
    if (off.x * off.x + off.y * off.y > radius * radius) return since;
    return since + leaves_circle(off, v, radius);
  }
  constexpr double kInscribed = 0.7071;
  return since + square_exit_bound(motion_.law(), TwoLanes{off.x, off.y}, TwoLanes{v.x, v.y},
                                   kInscribed * window_.skin);
}

}  // namespace carom::event
