#pragma once

#include <algorithm>
#include <array>

#include "solvers/event/event_loop.hpp"
#include "solvers/event/pair_lanes.hpp"

namespace carom::event {

inline constexpr std::uint32_t kSideBySide = 16;

template <class P>
void EventLoop<P>::predict_pairs(Index i, const Index* others, std::uint32_t count, At now,
                                 Meeting<P>& best) const {
  if constexpr (kInLanes) {
    if (left_.empty()) [[likely]] {
      predict_in_lanes(i, others, count, now, best);
      return;
    }
  }
  predict_mixed(i, others, count, now, best);
}

template <class P>
[[gnu::noinline]] void EventLoop<P>::predict_mixed(Index i, const Index* others,
                                                   std::uint32_t count, At now,
                                                   Meeting<P>& best) const {
  const auto predict_one = [&](Index other) {
    if (motion_.bends() && motion_.fixed(disks_[other])) {
      predict_fixed_disk(i, other, best);
    } else {
      predict_pair(i, other, now, best);
    }
  };
  if constexpr (kInLanes) {
    if (motion_.flies(disks_[i])) {
      // Those that fly like it are looked at side by side, in the order of the list.
      std::array<Index, kSideBySide> flying;
      std::uint32_t many = 0;
      for (std::uint32_t n = 0; n < count; ++n) {
        if (!motion_.flies(disks_[others[n]])) continue;
        flying[many++] = others[n];
        if (many < kSideBySide) continue;
        predict_in_lanes(i, flying.data(), many, now, best);
        many = 0;
      }
      if (many > 0) predict_in_lanes(i, flying.data(), many, now, best);
      for (std::uint32_t n = 0; n < count; ++n) {
        if (!motion_.flies(disks_[others[n]])) predict_one(others[n]);
      }
      return;
    }
  }
  for (std::uint32_t n = 0; n < count; ++n) predict_one(others[n]);
}

// What is stepped begins another flight at the next step, and is predicted again then.
template <class P>
auto EventLoop<P>::beyond_flight(const Disk& disk) const -> Time {
  const bool ends = next_step_ != P::Clock::never() && motion_.support(disk) >= kStepped;
  return ends ? Time(next_step_ + 1) : P::Clock::never();
}

template <class P>
void EventLoop<P>::predict_pair(Index i, Index other, At now, Meeting<P>& best) const {
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
void EventLoop<P>::predict_fixed_disk(Index i, Index fixed_disk, Meeting<P>& best) const {
  const Time at =
      motion_.pair_event(disks_[i], disks_[fixed_disk], !left_.empty() && left_[i] == fixed_disk);
  if (at == best.time && at != P::Clock::never()) note_tie(at, i, i);
  if (at < best.time) best = {at, fixed_disk};
}

// Looks no farther than its square, for then it looks again.
template <class P>
void EventLoop<P>::predict_alone(Index i, Meeting<P>& best) const {
  const Disk& me = disks_[i];
  const Meeting<P> alone = motion_.alone(me, std::min(best.time, me.leaves), spin(i));
  const bool known = alone.partner == me.partner;
  if (alone.time == best.time && alone.partner >= kWalls && !known) note_tie(alone.time, i, i);
  if (alone.time < best.time) best = alone;
}

// Finds what the ball meets before `meets`, which is no more than a time it is free until.
template <class P>
void EventLoop<P>::predict(Index i, At now) {
  const Disk& me = disks_[i];
  if (motion_.fixed(me)) return;
  ++counts_.predictions;
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
      predict_pairs(i, node->item, node->count, now, best);
      if (node->next == 0) break;
    }
  }
  if (!supported) predict_alone(i, best);
  if (best.time < now) best.time = now;
  link(i, best);
}

// A fixed ball waits for no other: it can be the partner of many.
template <class P>
void EventLoop<P>::link(Index i, const Meeting<P>& best) {
  if (best.partner == kUnknown) return;
  unlink(i);
  disks_[i].meets = best.time;
  disks_[i].partner = best.partner;
  if (best.partner >= kFirstMark || motion_.fixed(disks_[best.partner])) return;
  unlink(best.partner);
  disks_[best.partner].meets = best.time;
  disks_[best.partner].partner = i;
}

template <class P>
void EventLoop<P>::unlink(Index i) {
  const Index j = disks_[i].partner;
  disks_[i].partner = kUnknown;
  if (j < kFirstMark && disks_[j].partner == i) {
    disks_[j].partner = kUnknown;
    schedule(j);
  }
}

template <class P>
void EventLoop<P>::forget(Index i) {
  disks_[i].meets = P::Clock::never();
  disks_[i].partner = kUnknown;
}

}  // namespace carom::event
