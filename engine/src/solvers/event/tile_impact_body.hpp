#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "solvers/event/tile.hpp"

namespace carom::event {

template <class P>
void Tile<P>::watch(At now) {
  if (now != instant_) {
    instant_ = now;
    at_once_ = 0;
    if (now - watched_from_ > kShortTicks) {
      watched_from_ = now;
      watched_ = 0;
    }
  }
  ++watched_;
  const std::size_t balls = std::max(population_, disks_.size());
  if (++at_once_ > 1000 + 100 * balls || watched_ > kManyImpacts + 1000 * balls) {
    throw std::runtime_error(
        "impacts follow each other without end: such contacts are for method \"overlap\"");
  }
}

// What drag takes follows from the flight alone.
template <class P>
void Tile<P>::end_flight(Index i, At now) {
  if (motion_.rules().drag_rate > 0) {
    book_.add_drag(motion_.drag_loss(counted_[i], now));
    // An impact that did nothing leaves it on the flight it was on.
    if (disks_[i].start != now) book_.add_drag(-motion_.drag_loss(disks_[i], now));
  }
  count_turns(i, now);
  counted_[i] = disks_[i];
}

template <class P>
void Tile<P>::count_turns(Index i, At now) {
  if (turns_[0].empty() && turns_[1].empty()) return;
  const Vec<S> came = motion_.place(counted_[i], now);
  const auto count = [&](std::size_t axis, const S& from, const S& to) {
    if (turns_[axis].empty()) return;
    const S period = motion_.periods()[axis];
    turns_[axis][i] += std::llrint(static_cast<double>(S((from - to) / period)));
  };
  count(0, came.x, disks_[i].x);
  count(1, came.y, disks_[i].y);
}

// After a new flight has begun.
template <class P>
void Tile<P>::look_again(Index i, At now) {
  if (motion_.fixed(disks_[i])) return;
  if (!counted_.empty()) end_flight(i, now);
  if (paths_ != nullptr) {
    paths_->note(i, {disks_[i], left(i), spins_.empty() ? S(0) : spins_[i]});
  }
  if (motion_.rules().collisions) disks_[i].leaves = neighbours_.leaving(disks_[i], i, now);
  scan(i, now);
  announce(i);
}

template <class P>
void Tile<P>::meet_alone(Index i, Index partner, At now) {
  if (partner >= kWalls) {
    book_.note(motion_.bounce(disks_[i], spin(i), partner, now));
    ++counts_.ball_wall;
    if (!left_.empty()) left_[i] = kUnknown;
    if constexpr (kCanRest) lean(i);
    return;
  }
  const typename Motion<P>::Strike strike =
      motion_.strike(disks_[i], spin(i), disks_[partner], spin(partner), now);
  overlap_ = strike.overlap;
  book_.note(strike.lost);
  counts_.max_overlap = std::max(counts_.max_overlap, overlap_);
  ++counts_.ball_ball;
  if (!left_.empty()) {
    left_[i] = motion_.fixed(disks_[partner]) ? partner : kUnknown;
    left_[partner] = kUnknown;
  }
  if constexpr (kCanRest) {
    lean(i);
    lean(partner);
    if (motion_.clusters() && motion_.stay_together(disks_[i], disks_[partner])) {
      ++counts_.resting_contacts;
    }
  }
}

template <class P>
void Tile<P>::meet(Index i, At now) {
  const Index partner = disks_[i].partner;
  forget(i);
  if (partner == kUnknown) {
    ++counts_.vain;
    scan(i, now);
    announce(i);
    return;
  }
  if (partner == kCarry) {
    if (!left_.empty()) left_[i] = kUnknown;
    motion_.carry(disks_[i], now);
    look_again(i, now);
    return;
  }
  watch(now);
  const bool ball = partner < kFirstMark && !motion_.fixed(disks_[partner]);
  if (ball) forget(partner);
  if constexpr (kCanRest) {
    if (motion_.hops() && hit_crowd(i, partner, now)) return;
  }
  bool jointly = tied(now);
  if constexpr (kCanRest) {
    jointly = jointly ||
              (motion_.clusters() && ball && motion_.collapses(disks_[i], disks_[partner], now));
  }
  if (jointly) {
    meet_jointly(i, partner, now);
    return;
  }
  const Disk before = disks_[i];
  const Disk partner_before = ball ? disks_[partner] : Disk{};
  const S spin_before = spins_.empty() ? S(0) : spins_[i];
  const S partner_spin_before = spins_.empty() || !ball ? S(0) : spins_[partner];
  const Counts counts = counts_;
  const Index left = left_.empty() ? kUnknown : left_[i];
  const Index partner_left = left_.empty() || !ball ? kUnknown : left_[partner];
  meet_alone(i, partner, now);
  if (ball) look_again(partner, now);
  look_again(i, now);
  if (disks_[i].meets != now && !(ball && disks_[partner].meets == now)) {
    book_.keep();
    if (log_ != nullptr) {
      log_alone(i, partner, {before, spin_before}, {partner_before, partner_spin_before}, now);
    }
    return;
  }
  // The blow is passed on at once: take it back, and resolve all that touches together.
  counts_ = counts;
  book_.forget();
  const auto take_back = [this](Index k, const Disk& flight, const S& had) {
    unlink(k);
    const Time leaves = disks_[k].leaves;
    disks_[k] = flight;
    disks_[k].leaves = leaves;
    if (!spins_.empty()) spins_[k] = had;
    forget(k);
  };
  take_back(i, before, spin_before);
  if (ball) take_back(partner, partner_before, partner_spin_before);
  if (!left_.empty()) {
    left_[i] = left;
    if (ball) left_[partner] = partner_left;
  }
  meet_jointly(i, partner, now);
}

template <class P>
void Tile<P>::next_event(Index i, At now) {
  if (disks_[i].meets <= disks_[i].leaves) {
    meet(i, now);
    return;
  }
  ++counts_.renewals;
  const Flight<S> here = motion_.at(disks_[i], now);
  const std::span<const Index> fresh = neighbours_.renew(disks_, i, here);
  Meeting<P> best{disks_[i].meets, kUnknown};
  look_at(i, fresh.data(), static_cast<std::uint32_t>(fresh.size()), now, best);
  disks_[i].leaves = neighbours_.leaving(disks_[i], i, here, now);
  look_alone(i, best);
  link(i, best);
  announce(i);
}

}  // namespace carom::event
