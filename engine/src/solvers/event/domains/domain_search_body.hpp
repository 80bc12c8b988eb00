#pragma once

#include <algorithm>
#include <cmath>

#include "solvers/event/domains/domain_loop.hpp"

namespace carom::event {

// In time t a ball goes no farther than v t + a t^2 / 2.
template <class P>
[[gnu::always_inline]] inline bool DomainLoop<P>::flies_far(const BlockFlight& flight,
                                                            FixedTime until) const {
  if (until - flight.start >= kLongestFlight) return true;
  const double wait = motion_.rules().scale.seconds(until - flight.start);
  const double x = (std::abs(flight.vx) + pull_[0] * wait) * wait;
  const double y = (std::abs(flight.vy) + pull_[1] * wait) * wait;
  return !(x < farthest_[0] && y < farthest_[1]);
}

template <class P>
[[gnu::always_inline]] inline FixedTime DomainLoop<P>::pair_event(Slot i, Slot j) const {
  if constexpr (!P::Law::kStretches) {
    if (!bends_) return motion_.straight_pair_event(flights_[i], flights_[j]);
  }
  return motion_.pair_event(flights_[i], flights_[j]);
}

template <class P>
[[gnu::noinline]] void DomainLoop<P>::renew(Slot i, FixedTime now) {
  ++tally_.renewals;
  choose_circle(i, now);
  const Side& side = sides_[i];
  const std::uint32_t size = lists_.size(i);
  const Slot* const old = lists_.items(i);
  for (std::uint32_t k = 0; k < size; ++k) lists_.remove(old[k], i);
  lists_.clear(i);
  search_.move(i, side.x, side.y);
  if (radius(i) > normal_radius_) {
    search_.each_group(i, 0, static_cast<std::uint32_t>(flights_.size()),
                       [&](std::uint32_t k, std::uint32_t mask) { gathered_.add(k, mask); });
  } else {
    const std::uint32_t cell = cells_.cell_at(side.x, side.y);
    if (cell != cells_.cell_of(i)) {
      cells_.remove(i);
      cells_.add(i, cell);
    }
    std::uint32_t count = 0;
    cells_.each_near(cell, [&](Slot k) {
      around_[count] = k;
      count += k == i ? 0 : 1;
    });
    for (const Slot k : large_) around_[count++] = k;
    search_.each_of(i, around_.data(), count,
                    [&](const Slot* slots, std::uint32_t mask) { gathered_.add(slots, mask); });
  }
  lists_.set(i, gathered_);
  gathered_.clear();
  const std::uint32_t found = lists_.size(i);
  const Slot* const near = lists_.items(i);
  for (std::uint32_t k = 0; k < found; ++k) lists_.add(near[k], i);
  if (falls_on_fixed_) note_fixed(i);
  predict(i, now);
}

// The earliest event of the ball from now on: of a pair a lower bound, where nothing else comes as
// early.
template <class P>
[[gnu::noinline]] void DomainLoop<P>::predict(Slot i, FixedTime now) {
  const double since = seconds(now);
  if (tracked_ && since > sides_[i].limit) return;
  ++tally_.predictions;
  const Approach::Earliest found = earliest(i, straightened(since));
  keep_bound(i, found.first, found.second, found.ball, now);
}

// Both at once: what one waits for, the other has time to do.
template <class P>
[[gnu::noinline]] void DomainLoop<P>::predict_both(Slot i, Slot j, FixedTime now) {
  const double since = seconds(now);
  if (tracked_ && (since > sides_[i].limit || since > sides_[j].limit)) {
    predict(i, now);
    predict(j, now);
    return;
  }
  tally_.predictions += 2;
  const double bound_since = straightened(since);
  const Approach::Earliest of_i = earliest(i, bound_since);
  const Approach::Earliest of_j = earliest(j, bound_since);
  keep_bound(i, of_i.first, of_i.second, of_i.ball, now);
  keep_bound(j, of_j.first, of_j.second, of_j.ball, now);
}

// Of a time of the window, as the bounds count it.
template <class P>
[[gnu::always_inline]] inline double DomainLoop<P>::straightened(double since) const {
  if constexpr (P::Law::kStretches) {
    const double rate = motion_.law().rate;
    if (rate > 0) return -std::expm1(-rate * since) / rate;
  }
  return since;
}

// `since`: straightened.
template <class P>
[[gnu::always_inline]] inline Approach::Earliest DomainLoop<P>::earliest(Slot i,
                                                                         double since) const {
  return approach_.earliest(approach_.seer(paths_[i], i, sides_[i].by_end), paths_.data(),
                            lists_.items(i), lists_.size(i), all(since));
}

// `first`, with `partner`, and `others`: as the bounds of Approach.
template <class P>
[[gnu::always_inline]] inline void DomainLoop<P>::keep_bound(Slot i, double first, double others,
                                                             Slot partner, FixedTime now) {
  Side& side = sides_[i];
  if constexpr (P::Law::kStretches) {
    if (first < end_) first = motion_.law().when(first);
    if (others < end_) others = motion_.law().when(others);
  }
  const double soonest = std::min(first, side.leaves);
  if (!(soonest < end_)) {
    if (!side.exactly()) return;
    predict_exactly(i, now);
    return;
  }
  const FixedTime time =
      window_.from + static_cast<FixedTime>(soonest * motion_.rules().scale.per_second());
  const bool pair = first < side.leaves;
  if (side.exactly() || (pair && time <= now)) {
    predict_exactly(i, now);
    return;
  }
  const double next = std::min({others, side.leaves, end_});
  side.others = not_later(next);
  side.bounded = pair;
  side.partner = pair ? partner : slot_mark(kUnknown);
  if (pair) side.partner_changes = sides_[partner].changes;
  queue(i, std::max(time, now));
}

// A ball may be followed for longer than its partner, which then knows of the two from here alone.
template <class P>
[[gnu::always_inline]] inline void DomainLoop<P>::queue(Slot i, FixedTime time) {
  if (time > window_.until) return;
  const Side& side = sides_[i];
  if (tracked_ && side.limit < kToTheEnd) {
    float last = side.limit;
    if (side.partner < kFirstSlotMark) last = std::max(last, sides_[side.partner].limit);
    if (seconds(time) > last) return;
  }
  queue_.add(i, time - window_.from);
}

// The bound of the ball's event has come up.  Gives whether the event is due, and when; where it is
// not, it is queued again at its exact time.
template <class P>
[[gnu::always_inline]] inline bool DomainLoop<P>::make_exact(Slot i, FixedTime& now,
                                                             FixedTime until) {
  Side& side = sides_[i];
  const Slot j = side.partner;
  if (sides_[j].changes != side.partner_changes) return true;
  const FixedTime time = pair_event(i, j);
  side.bounded = false;
  if (time < now) unusual_ = true;
  if (time != kNever && seconds(time) < side.others) {
    // The partner mostly waits for the same event, and for nothing before it.
    const Side& other = sides_[j];
    const bool mutual = other.partner == i && other.partner_changes == side.changes &&
                        (!other.bounded || seconds(time) < other.others);
    if (time <= until && queue_.precedes(time - window_.from, mutual ? j : i)) {
      now = time;
      return true;
    }
    queue(i, time);
  } else {
    predict_exactly(i, now);
  }
  return false;
}

// The same as `predict` by exact times.
template <class P>
[[gnu::noinline]] void DomainLoop<P>::predict_exactly(Slot i, FixedTime now) {
  const Side& side = sides_[i];
  Meeting<P> best{};
  double soonest = std::min(end_, side.leaves);
  const Lanes present = all(straightened(seconds(now)));
  const std::uint32_t size = lists_.size(i);
  const Slot* const others = lists_.items(i);
  const Approach::Seer me = approach_.seer(paths_[i], i, side.by_end);
  for (std::uint32_t k = 0; k < size; k += kLanes) {
    const Lanes bounds = approach_.bounds(me, paths_.data(), others + k, present);
    const WholeLanes soon = bounds < all(soonest);
    if (!any(soon)) continue;
    for (std::uint32_t l = 0; l < kLanes && k + l < size; ++l) {
      if (soon[l] == 0) continue;
      const Slot j = others[k + l];
      const FixedTime at = pair_event(i, j);
      if (at <= now) {
        // What is no longer followed may overlap others.
        if (sides_[j].limit < seconds(now)) continue;
        unusual_ = true;
      }
      if (at == best.time && at != kNever) unusual_ = true;
      if (at < best.time) {
        best = {at, j};
        soonest = std::min(soonest, seconds(at));
      }
    }
  }
  if (side.has(kAtFixed)) meet_fixed(i, now, soonest, best);
  settle(i, best, now);
}

template <class P>
void DomainLoop<P>::note_fixed(Slot i) {
  const Slot* const others = lists_.items(i);
  const bool any =
      std::any_of(others, others + lists_.size(i), [this](Slot k) { return sides_[k].fixed; });
  sides_[i].set(kAtFixed, any && !sides_[i].fixed);
}

// What a ball that falls meets of the fixed ones near to it, where that comes first.
template <class P>
void DomainLoop<P>::meet_fixed(Slot i, FixedTime now, double soonest, Meeting<P>& best) {
  const double since = seconds(now);
  const Slot* const others = lists_.items(i);
  for (std::uint32_t k = 0; k < lists_.size(i); ++k) {
    const Slot j = others[k];
    if (!sides_[j].fixed || !may_reach(i, j, now, soonest - since)) continue;
    const FixedTime at =
        motion_.pair_event(flights_[i], flights_[j], lefts_[i] == flights_[j].ball);
    if (at <= now || (at == best.time && at != kNever)) unusual_ = true;
    if (at < best.time) {
      best = {at, j};
      soonest = std::min(soonest, seconds(at));
    }
  }
}

// Within so many seconds, or little more.
template <class P>
bool DomainLoop<P>::may_reach(Slot i, Slot fixed, FixedTime now, double wait) const {
  const Vec<double> at = place(i, now);
  double x = paths_[fixed].x - at.x;
  double y = paths_[fixed].y - at.y;
  if (window_.wraps[0]) x -= periods_[0] * std::rint(x * per_period_[0]);
  if (window_.wraps[1]) y -= periods_[1] * std::rint(y * per_period_[1]);
  const Vec<double> v = velocity(i, now);
  const double way =
      (std::sqrt(v.x * v.x + v.y * v.y) + bend_per_square_ * wait) * wait * (1 + 0x1p-20);
  const double reach = radius(i) + radius(fixed) + way + slack_;
  return x * x + y * y < reach * reach * (1 + 0x1p-20);
}

// With what it meets alone, and the end of its circle.
template <class P>
void DomainLoop<P>::settle(Slot i, Meeting<P> best, FixedTime now) {
  const BlockFlight& flight = flights_[i];
  Side& side = sides_[i];
  if (side.leaves < end_) {
    const FixedTime leaves =
        std::max(now, window_.from +
                          static_cast<FixedTime>(side.leaves * motion_.rules().scale.per_second()));
    if (leaves < best.time) best = {leaves, kUnknown};
  }
  const FixedTime soon = std::min(best.time, window_.until);
  if (side.has(kAtWall) || flies_far(flight, soon)) {
    const Meeting<P> alone = motion_.alone(flight, soon);
    if (alone.time <= soon) {
      if (alone.time == best.time && best.partner != kUnknown) unusual_ = true;
      if (alone.time <= now) unusual_ = true;
      best = alone;
    }
  }
  side.bounded = false;
  side.partner = slot_mark(best.partner);
  if (best.partner < kFirstMark) side.partner_changes = sides_[side.partner].changes;
  if (best.time != kNever) queue(i, best.time);
}

}  // namespace carom::event
