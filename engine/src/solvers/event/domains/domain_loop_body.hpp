#pragma once

#include <algorithm>

#include "solvers/event/domains/domain_loop.hpp"

namespace carom::event {

template <class P>
[[gnu::flatten]] bool DomainLoop<P>::advance_to(FixedTime until) {
  // So many are none of a window; EventLoop tells whether they end.
  const std::uint64_t most = tally_.events + 1000000 + 1000 * flights_.size();
  std::uint64_t next_timed = tally_.events + kEventsOfSample - tally_.events % kEventsOfSample;
  for (Slot i = queue_.first(until - window_.from); i != kNoSlot && !unusual_;
       i = queue_.first(until - window_.from)) {
    ++tally_.events;
    FixedTime now = window_.from + queue_.time(i);
    queue_.remove(i);
    if (sides_[i].bounded && !make_exact(i, now, until)) continue;
    if (tally_.events >= next_timed) {
      next_timed += kEventsOfSample;
      if (tally_.events > most) unusual_ = true;
      time_event(i, now);
    } else {
      handle(i, now);
    }
  }
  return !unusual_;
}

template <class P>
[[gnu::noinline]] void DomainLoop<P>::time_event(Slot i, FixedTime now) {
  TimedEvent<P> event;
  event.before = flights_[i].disk();
  event.partner = partner_of(sides_[i]);
  const auto j = static_cast<Slot>(event.partner);
  const bool at_ball = event.partner < kFirstMark;
  event.other_before = at_ball ? flights_[j].disk() : event.before;
  handle(i, now);
  event.after = flights_[i].disk();
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
[[gnu::always_inline]] inline void DomainLoop<P>::handle(Slot i, FixedTime now) {
  const Slot j = sides_[i].partner;
  if (j < kFirstSlotMark) {
    if (sides_[j].changes != sides_[i].partner_changes) {
      // It was to meet both at one instant.
      if (flights_[j].start == now) unusual_ = true;
      ++tally_.stale;
      predict(i, now);
      return;
    }
    meet(i, j, now);
    return;
  }
  const Index partner = partner_of(sides_[i]);
  if (partner == kUnknown) {
    renew(i, now);
    return;
  }
  end_flight(i, now);
  if (partner == kCarry) {
    motion_.carry(flights_[i], now);
  } else {
    // What is left of its approach to a fixed ball may be rounding.
    if (falls_on_fixed_ && flights_[i].start == now) unusual_ = true;
    const double lost = motion_.bounce(flights_[i], spin_of(i), partner, now);
    if (sides_[i].own) {
      ++tally_.walls;
      if (lost > 0) tally_.lost.push_back(lost);
    }
    if (contacts_last_ && rests_on_wall(i)) unusual_ = true;
  }
  if (falls_on_fixed_) lefts_[i] = kUnknown;
  fly_on(i, now);
  predict(i, now);
}

template <class P>
[[gnu::noinline]] bool DomainLoop<P>::sticks(Slot i, Slot j, FixedTime now) const {
  const Vec<double> r =
      motion_.way(motion_.place(flights_[i], now), motion_.place(flights_[j], now));
  return motion_.sticks(flights_[i], flights_[j], r, now);
}

template <class P>
[[gnu::noinline]] bool DomainLoop<P>::rests_on_wall(Slot i) const {
  Disk disk = flights_[i].disk();
  double spin = spins_.empty() ? 0 : spins_[i];
  (void)motion_.support_on_walls(disk, spins_.empty() ? nullptr : &spin);
  return motion_.support(disk) != 0;
}

template <class P>
[[gnu::noinline]] bool DomainLoop<P>::rests_on_fixed(Slot i, Slot fixed) const {
  Disk disk = flights_[i].disk();
  (void)motion_.support_on_fixed_disk(disk, flights_[fixed].disk());
  return motion_.support(disk) != 0;
}

// What drag has taken from it is counted where the ball is owned.
template <class P>
[[gnu::always_inline]] inline void DomainLoop<P>::end_flight(Slot i, FixedTime now) {
  if constexpr (P::Law::kStretches) {
    if (!books_flights_ || !sides_[i].own || sides_[i].fixed) return;
    const double lost = motion_.flight_loss(flights_[i].disk(), spin_of(i), now);
    if (lost != 0) tally_.lost.push_back(lost);
  }
}

// An impact counts where its balls are owned; the energy it takes, where the one of the lower
// number is.
template <class P>
[[gnu::flatten, gnu::noinline]] void DomainLoop<P>::meet(Slot i, Slot j, FixedTime now) {
  const bool moves = !sides_[j].fixed;
  if (queue_.holds(j)) {
    if (window_.from + queue_.time(j) == now && sides_[j].partner != i &&
        sides_[j].partner != slot_mark(kUnknown)) {
      unusual_ = true;
    }
    queue_.remove(j);
  }
  const bool clusters = motion_.clusters();
  if (clusters && moves && motion_.collapses(flights_[i], flights_[j], now)) unusual_ = true;
  if (contacts_last_ && sticks(i, j, now)) unusual_ = true;
  end_flight(i, now);
  end_flight(j, now);
  const typename Motion<P>::Strike strike =
      motion_.strike(flights_[i], spin_of(i), flights_[j], spin_of(j), now);
  if (clusters && motion_.stay_together(flights_[i], flights_[j])) unusual_ = true;
  if (contacts_last_ && (rests_on_wall(i) || (moves ? rests_on_wall(j) : rests_on_fixed(i, j)))) {
    unusual_ = true;
  }
  if (falls_on_fixed_) {
    lefts_[i] = moves ? kUnknown : flights_[j].ball;
    if (moves) lefts_[j] = kUnknown;
  }
  const bool own_i = sides_[i].own;
  const bool own_j = moves ? bool{sides_[j].own} : own_i;
  if (own_i || own_j) {
    tally_.ball_halves += (own_i ? 1U : 0U) + (own_j ? 1U : 0U);
    tally_.max_overlap = std::max(tally_.max_overlap, strike.overlap);
    if (strike.lost > 0) {
      const bool first = !moves || memories_[i] < memories_[j];
      if (first ? own_i : own_j) tally_.lost.push_back(strike.lost);
    }
  }
  fly_on(i, now);
  if (moves) {
    fly_on(j, now);
    predict_both(j, i, now);
  } else {
    predict(i, now);
  }
}

template <class P>
std::size_t DomainLoop<P>::bytes() const {
  return loading_.capacity() * sizeof(Loaded) + flights_.capacity() * sizeof(BlockFlight) +
         lefts_.capacity() * sizeof(Index) + paths_.capacity() * sizeof(Path) +
         sides_.capacity() * sizeof(Side) + tracks_.capacity() * sizeof(Track) +
         memories_.capacity() * sizeof(Index) + lists_.bytes() + cells_.bytes() + search_.bytes() +
         queue_.bytes();
}

}  // namespace carom::event
