#pragma once

#include <algorithm>

#include "solvers/event/prediction.hpp"

namespace carom::event {

template <class P>
Meeting<P> Prediction<P>::next(Index i, At now) const {
  const Disk& me = disks_[i];
  Meeting<P> best{me.meets, kUnknown};
  const bool supported = motion_.contacts_last() && !motion_.flies(me);
  if (supported) {
    // First, as it leaves less to look for.
    best.time = std::min(best.time, beyond_flight(me));
    const Meeting<P> alone = motion_.alone(me, best.time, spin(i));
    if (alone.time < best.time) best = alone;
  }
  if (motion_.rules().collisions) {
    const auto& lists = neighbours_.lists();
    for (const auto* node = &lists.first(i);; node = &lists.after(*node)) {
      add_pairs(i, node->item, node->count, now, best);
      if (node->next == 0) break;
    }
  }
  if (!supported) add_alone(i, best);
  if (best.time < now) best.time = now;
  return best;
}

template <class P>
Meeting<P> Prediction<P>::next_of(Index i, std::span<const Index> others, At now) const {
  Meeting<P> best{disks_[i].meets, kUnknown};
  add_pairs(i, others.data(), static_cast<std::uint32_t>(others.size()), now, best);
  add_alone(i, best);
  return best;
}

template <class P>
void Prediction<P>::in_lanes(Index i, const Index* others, std::uint32_t count, At now,
                             Meeting<P>& best) const requires kIsDouble<S> {
  const LaneSearch<P> search(motion_, disks_.data());
  search.find(i, others, count, now, best,
              [this](FixedTime at, Index one, Index other) { note_tie(at, one, other); });
}

template <class P>
void Prediction<P>::add_pairs(Index i, const Index* others, std::uint32_t count, At now,
                              Meeting<P>& best) const {
  if constexpr (kIsDouble<S>) {
    if (left_.empty()) [[likely]] {
      in_lanes(i, others, count, now, best);
      return;
    }
  }
  add_mixed(i, others, count, now, best);
}

template <class P>
[[gnu::noinline]] void Prediction<P>::add_mixed(Index i, const Index* others, std::uint32_t count,
                                                At now, Meeting<P>& best) const {
  const auto add_one = [&](Index other) {
    if (motion_.bends() && motion_.fixed(disks_[other])) {
      add_fixed_disk(i, other, best);
    } else {
      add_pair(i, other, now, best);
    }
  };
  if constexpr (kIsDouble<S>) {
    if (motion_.flies(disks_[i])) {
      // Those that fly like it are looked at side by side, in the order of the list.
      std::array<Index, kSideBySide> flying;
      std::uint32_t many = 0;
      for (std::uint32_t n = 0; n < count; ++n) {
        if (!motion_.flies(disks_[others[n]])) continue;
        flying[many++] = others[n];
        if (many < kSideBySide) continue;
        in_lanes(i, flying.data(), many, now, best);
        many = 0;
      }
      if (many > 0) in_lanes(i, flying.data(), many, now, best);
      for (std::uint32_t n = 0; n < count; ++n) {
        if (!motion_.flies(disks_[others[n]])) add_one(others[n]);
      }
      return;
    }
  }
  for (std::uint32_t n = 0; n < count; ++n) add_one(others[n]);
}

// What is stepped begins another flight at the next step, and is predicted again then.
template <class P>
auto Prediction<P>::beyond_flight(const Disk& disk) const -> Time {
  const bool ends = next_step_ != P::Clock::never() && motion_.support(disk) >= kStepped;
  return ends ? Time(next_step_ + 1) : P::Clock::never();
}

template <class P>
void Prediction<P>::add_pair(Index i, Index other, At now, Meeting<P>& best) const {
  const Disk& disk = disks_[other];
  Time beyond = P::Clock::never();
  Time at;
  if (motion_.rests()) {
    beyond = std::min(beyond_flight(disks_[i]), beyond_flight(disk));
    at = motion_.pair_event(disks_[i], disk, false, std::min({best.time, disk.meets, beyond}));
  } else {
    at = motion_.pair_event(disks_[i], disk);
  }
  if (at == P::Clock::never() || !(at < beyond)) return;
  if (at < now) at = now;
  if (at == disk.meets && disk.partner != i) note_tie(at, i, other);
  if (!(at < disk.meets)) return;
  if (at == best.time) note_tie(at, i, other);
  if (at < best.time) best = {at, other};
}

template <class P>
void Prediction<P>::add_fixed_disk(Index i, Index fixed_disk, Meeting<P>& best) const {
  const Time at =
      motion_.pair_event(disks_[i], disks_[fixed_disk], !left_.empty() && left_[i] == fixed_disk);
  if (at == best.time && at != P::Clock::never()) note_tie(at, i, i);
  if (at < best.time) best = {at, fixed_disk};
}

// Looks no farther than its square, for then it looks again.
template <class P>
void Prediction<P>::add_alone(Index i, Meeting<P>& best) const {
  const Disk& me = disks_[i];
  const Meeting<P> alone = motion_.alone(me, std::min(best.time, me.leaves), spin(i));
  const bool known = alone.partner == me.partner;
  if (alone.time == best.time && alone.partner >= kWalls && !known) note_tie(alone.time, i, i);
  if (alone.time < best.time) best = alone;
}

}  // namespace carom::event
