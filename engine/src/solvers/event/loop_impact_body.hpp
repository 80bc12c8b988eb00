#pragma once

#include <algorithm>
#include <cmath>

#include "solvers/event/event_loop.hpp"
#include "solvers/event/nearing.hpp"

namespace carom::event {

template <class P>
void EventLoop<P>::watch(At now) {
  if (now != impact_time_) {
    impact_time_ = now;
    begin_simultaneous();
    jam_watch_.begin_instant(now);
  }
  if (!jam_watch_.note_impact()) return;
  // What was resolved without all that is so near is to be resolved with it.
  pairs_.forget_resolved();
}

template <class P>
void EventLoop<P>::end_flight(Index i, At now) {
  if (motion_.loses_in_flight()) writer_.slides(i, ended_.flight(i), ended_.spin(i), now);
  ended_.end(i, disks_[i], spin(i), now);
}

template <class P>
void EventLoop<P>::predict_changed(At now) {
  for (const Index i : changed_) predict_again(i, now);
  changed_.clear();
}

template <class P>
void EventLoop<P>::predict(Index i, At now) {
  if (motion_.fixed(disks_[i])) return;
  ++counts_.predictions;
  schedule_.link(i, prediction_.next(i, now));
}

// After a new flight has begun.
template <class P>
void EventLoop<P>::predict_again(Index i, At now) {
  if (motion_.fixed(disks_[i])) return;
  if (ended_.any()) end_flight(i, now);
  if (paths_ != nullptr) {
    paths_->note(i, {disks_[i], left(i), spins_.empty() ? S(0) : spins_[i]});
  }
  if (motion_.rules().collisions) disks_[i].leaves = neighbours_.leaving(disks_[i], i, now);
  predict(i, now);
  schedule_.add(i);
}

template <class P>
void EventLoop<P>::meet_alone(Index i, Index partner, At now) {
  if (partner >= kWalls) {
    const Index was_left = disks_[i].start == now ? left(i) : kUnknown;
    book_.note(motion_.bounce(disks_[i], spin(i), partner, now));
    ++counts_.ball_wall;
    if (jam_watch_.level().jammed()) {
      const double lost = motion_.end_bounce(disks_[i], partner);
      if (lost > 0) ++counts_.jammed;
      book_.note(lost);
    }
    // In a gap of zero between the two it goes on along both: what is left of its approach is
    // rounding.
    const bool along =
        was_left != kUnknown && !nears_ball(motion_, disks_[i], disks_[was_left], now);
    if (!left_.empty()) left_[i] = along ? was_left : kUnknown;
    supports_.update(i);
    return;
  }
  const typename Motion<P>::Strike strike =
      motion_.strike(disks_[i], spin(i), disks_[partner], spin(partner), now);
  book_.note(strike.lost);
  counts_.max_overlap = std::max(counts_.max_overlap, strike.overlap);
  ++counts_.ball_ball;
  if (!left_.empty()) {
    left_[i] = motion_.fixed(disks_[partner]) ? partner : kUnknown;
    left_[partner] = kUnknown;
  }
  supports_.update(i);
  supports_.update(partner);
  if (motion_.clusters() && motion_.stay_together(disks_[i], disks_[partner])) {
    ++counts_.resting_contacts;
  }
}

template <class P>
void EventLoop<P>::meet(Index i, At now) {
  const Index partner = disks_[i].partner;
  if (partner == kUnknown) {
    ++counts_.stale;
    if (now == impact_time_ && resolutions_.any() && is_late(i, now)) return;
    schedule_.forget(i);
    predict(i, now);
    schedule_.add(i);
    return;
  }
  schedule_.forget(i);
  if (partner == kCarry) {
    if (motion_.support(disks_[i]) == kStepped) {
      // What gravity owes it, it owes to its island.
      watch(now);
      hit_islands({{i}}, now);
      predict_changed(now);
      return;
    }
    // What lies on a fixed ball has not left it.
    if (!left_.empty() && motion_.support(disks_[i]) != kLying) left_[i] = kUnknown;
    motion_.carry(disks_[i], now, spin(i));
    predict_again(i, now);
    return;
  }
  if (partner == kSettles) {
    settle(i, now);
    return;
  }
  watch(now);
  if (moves(partner)) schedule_.forget(partner);
  pairs_.wait(i, partner);
}

template <class P>
void EventLoop<P>::next_event(Index i, At now) {
  if (disks_[i].meets <= disks_[i].leaves) {
    meet(i, now);
    return;
  }
  ++counts_.renewals;
  const Flight<S> here = motion_.at(disks_[i], now);
  const std::span<const Index> fresh = neighbours_.renew(disks_, i, here);
  disks_[i].leaves = neighbours_.leaving(disks_[i], i, here, now);
  schedule_.link(i, prediction_.next_of(i, fresh, now));
  schedule_.add(i);
}

}  // namespace carom::event
