#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "solvers/event/domains/domain_loop.hpp"
#include "solvers/event/exit_lanes.hpp"

namespace carom::event {

template <class P>
bool DomainLoop<P>::advance_to(Ticks until) {
  // So many are none of a window; Tile tells whether they end.
  const std::uint64_t most = tally_.events + 1000000 + 1000 * disks_.size();
  for (Slot i = queue_.first(until - window_.from); i != kNoSlot && !unusual_;
       i = queue_.first(until - window_.from)) {
    if (++tally_.events > most) unusual_ = true;
    const Ticks now = window_.from + queue_.time(i);
    queue_.remove(i);
    if (tally_.events % kEventsOfSample == 0) {
      time_event(i, now);
    } else {
      handle(i, now);
    }
  }
  return !unusual_;
}

template <class P>
[[gnu::noinline]] void DomainLoop<P>::time_event(Slot i, Ticks now) {
  TimedEvent<P> event;
  event.before = disks_[i];
  event.partner = event.before.partner;
  const auto j = static_cast<Slot>(event.partner);
  const bool at_ball = event.partner < kFirstMark;
  event.other_before = at_ball ? disks_[j] : event.before;
  handle(i, now);
  event.after = disks_[i];
  event.until = queue_.holds(i) ? window_.from + queue_.time(i) : window_.until;
  event.spins = !spins_.empty();
  if (event.spins) {
    event.spin = spins_[i];
    if (at_ball) event.other_spin = spins_[j];
  }
  const Costs costs = costs_beside_pairs(motion_, event, now);
  tally_.costs.walls += kEventsOfSample * costs.walls;
  tally_.costs.friction += kEventsOfSample * costs.friction;
  tally_.costs.bending += kEventsOfSample * costs.bending;
}

template <class P>
void DomainLoop<P>::handle(Slot i, Ticks now) {
  const Index partner = disks_[i].partner;
  if (partner < kFirstMark) {
    const auto j = static_cast<Slot>(partner);
    if (sides_[j].changes != sides_[i].partner_changes) {
      // It was to meet both at one instant.
      if (disks_[j].start == now) unusual_ = true;
      ++tally_.stale;
      scan(i, now);
      return;
    }
    meet(i, j, now);
    return;
  }
  if (partner == kUnknown) {
    renew(i, now);
    return;
  }
  if (partner == kCarry) {
    motion_.carry(disks_[i], now);
  } else {
    const double lost = motion_.bounce(disks_[i], spin_of(i), partner, now);
    if (sides_[i].own != 0) {
      ++tally_.walls;
      if (lost > 0) tally_.lost.push_back(lost);
    }
  }
  fly_on(i, now);
  scan(i, now);
}

// An impact counts where its balls are owned; the energy it takes, where the one of the lower
// number is.
template <class P>
void DomainLoop<P>::meet(Slot i, Slot j, Ticks now) {
  const bool moves = sides_[j].fixed == 0;
  if (queue_.holds(j)) {
    if (window_.from + queue_.time(j) == now && disks_[j].partner != i &&
        disks_[j].partner != kUnknown) {
      unusual_ = true;
    }
    queue_.remove(j);
  }
  const typename Motion<P>::Strike strike =
      motion_.strike(disks_[i], spin_of(i), disks_[j], spin_of(j), now);
  const bool own_i = sides_[i].own != 0;
  const bool own_j = moves ? sides_[j].own != 0 : own_i;
  if (own_i || own_j) {
    tally_.ball_halves += (own_i ? 1U : 0U) + (own_j ? 1U : 0U);
    tally_.max_overlap = std::max(tally_.max_overlap, strike.overlap);
    if (strike.lost > 0) {
      const bool first = !moves || sides_[i].memory < sides_[j].memory;
      if (first ? own_i : own_j) tally_.lost.push_back(strike.lost);
    }
  }
  fly_on(i, now);
  if (moves) fly_on(j, now);
  if (moves) scan(j, now);
  scan(i, now);
}

// The flight has just begun.
template <class P>
[[gnu::always_inline]] inline void DomainLoop<P>::fly_on(Slot i, Ticks now) {
  const Disk& disk = disks_[i];
  Side& side = sides_[i];
  ++side.changes;
  const auto mix = [&](std::uint64_t bits) {
    side.history = (side.history ^ bits) * 0x9e3779b97f4a7c15U;
    side.history ^= side.history >> 32;
  };
  mix(static_cast<std::uint64_t>(now) ^ (std::bit_cast<std::uint64_t>(disk.vx) << 1));
  mix(std::bit_cast<std::uint64_t>(disk.vy));
  if (!spins_.empty()) mix(std::bit_cast<std::uint64_t>(spins_[i]));
  Path& path = paths_[i];
  const double dx = disk.x - window_.middle[0] - side.x;
  const double dy = disk.y - window_.middle[1] - side.y;
  const double shift_x = window_.middle[0] + periods_[0] * std::rint(dx * per_period_[0]);
  const double shift_y = window_.middle[1] + periods_[1] * std::rint(dy * per_period_[1]);
  note_place(i, disk.x - shift_x, disk.y - shift_y);
  if (!bends_) {
    const double since = seconds(now);
    path = {disk.x - shift_x - since * disk.vx, disk.y - shift_y - since * disk.vy, disk.vx,
            disk.vy};
  } else {
    const Vec<double> at = motion_.place(disk, window_.from);
    const Vec<double> v = motion_.velocity(disk, window_.from);
    path = {at.x - shift_x, at.y - shift_y, v.x, v.y};
  }
  side.leaves = exit(i, now);
}

// Straight flights are farthest from anywhere where they begin or end.
template <class P>
[[gnu::always_inline]] inline void DomainLoop<P>::note_place(std::size_t i, double x, double y) {
  Trip& trip = trips_[i];
  const float dx = static_cast<float>(x) - trip.x;
  const float dy = static_cast<float>(y) - trip.y;
  trip.square = std::max(trip.square, dx * dx + dy * dy);
}

// What gravity bends a flight by adds to that.
template <class P>
float DomainLoop<P>::displacement(std::size_t k) {
  if (sides_[k].fixed != 0) return 0;
  const Vec<double> at = place(static_cast<Slot>(k), window_.until);
  note_place(k, at.x, at.y);
  return static_cast<float>((std::sqrt(static_cast<double>(trips_[k].square)) + bend_) *
                            (1 + 0x1p-16));
}

// Where the ball is, in the image that its path is in.
template <class P>
Vec<double> DomainLoop<P>::place(Slot i, Ticks now) const {
  const Path& path = paths_[i];
  if (!bends_) {
    const double since = seconds(now);
    return {path.x + since * path.vx, path.y + since * path.vy};
  }
  const Vec<double> then = motion_.place(disks_[i], window_.from);
  const Vec<double> at = motion_.place(disks_[i], now);
  return {path.x + (at.x - then.x), path.y + (at.y - then.y)};
}

template <class P>
void DomainLoop<P>::choose_circle(Slot i, Ticks now) {
  const Vec<double> at = place(i, now);
  Side& side = sides_[i];
  side.x = at.x;
  side.y = at.y;
  side.leaves = exit(i, now);
  look_for_walls(i);
}

// Its circle, its radius taken off the room it has.
template <class P>
[[gnu::always_inline]] inline void DomainLoop<P>::look_for_walls(Slot i) {
  Side& side = sides_[i];
  const double reach = (window_.skin + radius(i)) * (1 + 0x1p-20);
  const auto clear = [&](std::size_t axis, double x) {
    return !motion_.room().solid(axis) ||
           (x - reach > window_.lowest[axis] && x + reach < window_.highest[axis]);
  };
  side.at_wall = clear(0, side.x) && clear(1, side.y) ? 0 : 1;
}

// In time t a ball goes no farther than v t + a t^2 / 2.
template <class P>
[[gnu::always_inline]] inline bool DomainLoop<P>::meets_nothing_alone(const Disk& disk,
                                                                      const Side& side,
                                                                      Ticks until) const {
  if (until - disk.start >= kLongestFlight) return false;
  const double wait = motion_.rules().scale.seconds(until - disk.start);
  const double x = (std::abs(disk.vx) + pull_[0] * wait) * wait;
  const double y = (std::abs(disk.vy) + pull_[1] * wait) * wait;
  return side.at_wall == 0 && x < farthest_[0] && y < farthest_[1];
}

template <class P>
[[gnu::always_inline]] inline Ticks DomainLoop<P>::pair_meets(Slot i, Slot j) const {
  if constexpr (!P::Law::kStretches) {
    if (!bends_) return motion_.straight_pair_meets(disks_[i], disks_[j]);
  }
  return motion_.pair_meets(disks_[i], disks_[j]);
}

// Not before it is `skin` from the middle of its circle.
template <class P>
[[gnu::always_inline]] inline double DomainLoop<P>::exit(Slot i, Ticks now) const {
  const Side& side = sides_[i];
  const Path& path = paths_[i];
  if (!bends_) {
    const double x = path.x - side.x;
    const double y = path.y - side.y;
    const double square = path.vx * path.vx + path.vy * path.vy;
    const double along = x * path.vx + y * path.vy;
    const double gap = window_.skin * window_.skin - x * x - y * y;
    if (!(square > 0)) return never<double>();
    return (std::sqrt(std::max(0.0, along * along + square * gap)) - along) / square;
  }
  constexpr double kInscribed = 0.7071;
  const Flight<double> here = motion_.at(disks_[i], now);
  const Vec<double> at = place(i, now);
  const double wait = motion_.ask(disks_[i], [&](const auto& law) {
    return square_exit_bound(law, TwoLanes{at.x - side.x, at.y - side.y},
                             TwoLanes{here.velocity.x, here.velocity.y}, kInscribed * window_.skin);
  });
  return seconds(now) + wait;
}

template <class P>
[[gnu::noinline]] void DomainLoop<P>::renew(Slot i, Ticks now) {
  ++tally_.renewals;
  choose_circle(i, now);
  const Side& side = sides_[i];
  const std::uint32_t size = lists_.size(i);
  const Slot* const old = lists_.items(i);
  for (std::uint32_t k = 0; k < size; ++k) lists_.remove(old[k], i);
  lists_.clear(i);
  const double my_radius = radius(i);
  const double same = 2 * my_radius + near_;
  const bool wraps = window_.wraps[0] || window_.wraps[1];
  const auto try_link = [&](Slot k) {
    if (k == i) return;
    double x = sides_[k].x - side.x;
    double y = sides_[k].y - side.y;
    if (wraps) {
      if (window_.wraps[0]) x -= periods_[0] * std::rint(x * per_period_[0]);
      if (window_.wraps[1]) y -= periods_[1] * std::rint(y * per_period_[1]);
    }
    const double reach = mixed_ ? my_radius + radii_[k] + near_ : same;
    if (x * x + y * y < reach * reach) link(i, k);
  };
  if (my_radius > normal_radius_) {
    for (std::size_t k = 0; k < disks_.size(); ++k) try_link(static_cast<Slot>(k));
  } else {
    const std::uint32_t cell = cells_.cell_at(side.x, side.y);
    if (cell != cells_.cell_of(i)) {
      cells_.remove(i);
      cells_.add(i, cell);
    }
    cells_.each_near(cell, try_link);
    for (const Slot k : large_) try_link(k);
  }
  scan(i, now);
}

// The earliest event of the ball from now on.
template <class P>
void DomainLoop<P>::scan(Slot i, Ticks now) {
  const Side& side = sides_[i];
  if (now > side.limit) return;
  ++tally_.scans;
  Meeting<P> best{};
  double soonest = std::min(end_, side.leaves);
  double since = seconds(now);
  if constexpr (P::Law::kStretches) {
    const double rate = motion_.law().rate;
    if (rate > 0) since = -std::expm1(-rate * since) / rate;
  }
  const Lanes present = all(since);
  const std::uint32_t size = lists_.size(i);
  const Slot* const others = lists_.items(i);
  const typename Approach::Seer me = approach_.seer(paths_[i], i);
  for (std::uint32_t k = 0; k < size; k += kLanes) {
    const Lanes bounds = approach_.bounds(me, paths_.data(), others + k, present);
    const WholeLanes soon = bounds < all(soonest);
    if (!any(soon)) continue;
    for (std::uint32_t l = 0; l < kLanes && k + l < size; ++l) {
      if (soon[l] == 0) continue;
      const Slot j = others[k + l];
      const Ticks at = pair_meets(i, j);
      if (at <= now) {
        // What is no longer followed may overlap others.
        if (sides_[j].limit < now) continue;
        unusual_ = true;
      }
      if (at == best.time && at != kNever) unusual_ = true;
      if (at < best.time) {
        best = {at, j};
        soonest = std::min(soonest, seconds(at));
      }
    }
  }
  settle(i, best, now);
}

// With what it meets alone, and the end of its circle.
template <class P>
[[gnu::always_inline]] inline void DomainLoop<P>::settle(Slot i, Meeting<P> best, Ticks now) {
  Disk& disk = disks_[i];
  Side& side = sides_[i];
  if (side.leaves < end_) {
    const Ticks leaves = std::max(
        now, window_.from + static_cast<Ticks>(side.leaves * motion_.rules().scale.per_second()));
    if (leaves < best.time) best = {leaves, kUnknown};
  }
  Ticks last = std::min(window_.until, side.limit);
  const Ticks soon = std::min(best.time, last);
  if (!meets_nothing_alone(disk, side, soon)) {
    const Meeting<P> alone = motion_.alone(disk, soon);
    if (alone.time <= soon) {
      if (alone.time == best.time && best.partner != kUnknown) unusual_ = true;
      if (alone.time <= now) unusual_ = true;
      best = alone;
    }
  }
  disk.partner = best.partner;
  if (best.partner < kFirstMark) {
    const Side& other = sides_[static_cast<Slot>(best.partner)];
    side.partner_changes = other.changes;
    // The other may be followed for longer, and know of it from here alone.
    last = std::min(window_.until, std::max(side.limit, other.limit));
  }
  if (best.time > last) return;
  queue_.add(i, best.time - window_.from);
}

template <class P>
std::size_t DomainLoop<P>::bytes() const {
  return loading_.capacity() * sizeof(Loaded) + disks_.capacity() * sizeof(Disk) +
         paths_.capacity() * sizeof(Path) + sides_.capacity() * sizeof(Side) +
         trips_.capacity() * sizeof(Trip) + lists_.bytes() + cells_.bytes() + queue_.bytes();
}

}  // namespace carom::event
