#pragma once

#include <algorithm>

#include "solvers/event/pair_lanes.hpp"
#include "solvers/event/tile.hpp"

namespace carom::event {

template <class P>
void Tile<P>::look_at(Index i, const Index* others, std::uint32_t count, At now,
                      Meeting<P>& best) const {
  if (!kInLanes || !left_.empty()) {
    for (std::uint32_t n = 0; n < count; ++n) {
      if (P::Law::kBends && motion_.fixed(disks_[others[n]])) {
        look_at_peg(i, others[n], best);
      } else {
        look_singly(i, others[n], now, best);
      }
    }
  } else if constexpr (kInLanes) {
    look_in_lanes(i, others, count, now, best);
  }
}

template <class P>
void Tile<P>::look_singly(Index i, Index other, At now, Meeting<P>& best) const {
  const Disk& disk = disks_[other];
  Time at{};
  if constexpr (P::kRests) {
    at = motion_.pair_meets(disks_[i], disk, false, std::min(best.time, disk.meets));
  } else {
    at = motion_.pair_meets(disks_[i], disk);
  }
  if (at == P::Clock::never()) return;
  if (at < now) at = now;
  if (at == disk.meets && disk.partner != i) note_tie(at);
  if (!(at < disk.meets)) return;
  if (at == best.time) note_tie(at);
  if (at < best.time) best = {at, other};
}

template <class P>
void Tile<P>::look_at_peg(Index i, Index peg, Meeting<P>& best) const {
  const Time at = motion_.pair_meets(disks_[i], disks_[peg], !left_.empty() && left_[i] == peg);
  if (at == best.time && at != P::Clock::never()) note_tie(at);
  if (at < best.time) best = {at, peg};
}

// Looks no farther than its square, for then it looks again.
template <class P>
void Tile<P>::look_alone(Index i, Meeting<P>& best) const {
  const Disk& me = disks_[i];
  const Meeting<P> alone = motion_.alone(me, std::min(best.time, me.leaves));
  const bool known = alone.partner == me.partner;
  if (alone.time == best.time && alone.partner != kCarry && !known) note_tie(alone.time);
  if (alone.time < best.time) best = alone;
}

// Finds what the ball meets before `meets`, which is no more than a time it is free until.
template <class P>
void Tile<P>::scan(Index i, At now) {
  const Disk& me = disks_[i];
  if (motion_.fixed(me)) return;
  ++counts_.scans;
  Meeting<P> best{me.meets, kUnknown};
  if constexpr (P::kRests) {
    // First, as it leaves less to look for.
    const Meeting<P> alone = motion_.alone(me);
    if (alone.time < best.time) best = alone;
  }
  if (motion_.rules().collisions) {
    const auto& lists = neighbours_.lists();
    for (const auto* node = &lists.first(i);; node = &lists.after(*node)) {
      look_at(i, node->item, node->count, now, best);
      if (node->next == 0) break;
    }
  }
  if constexpr (!P::kRests) look_alone(i, best);
  if (best.time < now) best.time = now;
  link(i, best);
}

// A fixed ball waits for nobody: it can be the partner of many.
template <class P>
void Tile<P>::link(Index i, const Meeting<P>& best) {
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
void Tile<P>::unlink(Index i) {
  const Index j = disks_[i].partner;
  disks_[i].partner = kUnknown;
  if (j < kFirstMark && disks_[j].partner == i) {
    disks_[j].partner = kUnknown;
    announce(j);
  }
}

template <class P>
void Tile<P>::forget(Index i) {
  disks_[i].meets = P::Clock::never();
  disks_[i].partner = kUnknown;
}

}  // namespace carom::event
