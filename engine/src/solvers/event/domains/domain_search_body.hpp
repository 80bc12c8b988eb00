#pragma once

#include <algorithm>
#include <cmath>

#include "solvers/event/domains/domain_loop.hpp"

namespace carom::event {

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

}  // namespace carom::event
