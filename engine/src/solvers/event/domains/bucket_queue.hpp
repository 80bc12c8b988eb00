#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/event/domains/near_lists.hpp"
#include "solvers/event/fixed_time.hpp"
#include "solvers/event/huge_pages.hpp"

namespace carom::event {

/// One event for each ball of a domain, over one window of time.
///
/// The window is cut into as many buckets as there are events, a doubly linked list each; the
/// earliest of the present bucket is looked for.
/// REQUIRES: events beyond the window are not queued.
///
/// Times count from the start of the window.
/// Source: G. Paul, A complexity O(1) priority queue for event driven molecular dynamics
/// simulations, J. Comput. Phys. 221 (2007) 615.
class BucketQueue {
 public:
  static constexpr std::uint32_t kMostBuckets = 0xfff0;

  /// Empties it.  `buckets_of_ball`: for its events in the window.
  /// REQUIRES: `window` > 0.
  void reset(std::size_t balls, FixedTime window, double buckets_of_ball = 1) {
    const double wanted = static_cast<double>(balls) * buckets_of_ball;
    const auto buckets = static_cast<std::uint32_t>(std::clamp(wanted, 16.0, double{kMostBuckets}));
    heads_.assign(buckets + 1, kNoSlot);
    heads_[buckets] = kEnd;
    entries_.assign(balls, Entry{});
    last_ = buckets - 1;
    present_ = 0;
    per_tick_ = buckets / static_cast<double>(window);
  }

  [[nodiscard]] bool holds(Slot ball) const { return entries_[ball].bucket != kNoSlot; }
  /// REQUIRES: it holds the ball.
  [[nodiscard]] FixedTime time(Slot ball) const { return entries_[ball].time; }

  /// REQUIRES: it does not hold the ball.
  void add(Slot ball, FixedTime time) {
    const std::uint32_t bucket = std::max(bucket_of(time), present_);
    const Slot next = heads_[bucket];
    entries_[ball] = {time, next, kNoSlot, static_cast<Slot>(bucket)};
    if (next != kNoSlot) entries_[next].before = ball;
    heads_[bucket] = ball;
  }

  /// Takes the ball out, where it is in it.
  void remove(Slot ball) {
    Entry& entry = entries_[ball];
    if (entry.bucket == kNoSlot) return;
    if (entry.next != kNoSlot) entries_[entry.next].before = entry.before;
    if (entry.before != kNoSlot) {
      entries_[entry.before].next = entry.next;
    } else {
      heads_[entry.bucket] = entry.next;
    }
    entry.bucket = kNoSlot;
  }

  /// The ball with the earliest event, where that is not after `until`; else kNoSlot.
  /// REQUIRES: what is added from now on is not before the event.
  [[nodiscard]] Slot first(FixedTime until) {
    Slot best = heads_[present_];
    while (best == kNoSlot) best = heads_[++present_];
    if (best == kEnd) {
      present_ = last_;
      return kNoSlot;
    }
    for (Slot k = entries_[best].next; k != kNoSlot; k = entries_[k].next) {
      if (entries_[k].time < entries_[best].time) best = k;
    }
    return entries_[best].time <= until ? best : kNoSlot;
  }

  /// Whether all events that it holds are later, but for that of one ball.
  /// REQUIRES: nothing that it holds is before what `first` gave last.
  [[nodiscard]] bool precedes(FixedTime time, Slot but) const {
    if (bucket_of(time) > present_) return false;
    for (Slot k = heads_[present_]; k != kNoSlot; k = entries_[k].next) {
      if (entries_[k].time <= time && k != but) return false;
    }
    return true;
  }

  [[nodiscard]] std::size_t bytes() const {
    return heads_.capacity() * sizeof(Slot) + entries_.capacity() * sizeof(Entry);
  }

 private:
  [[nodiscard]] std::uint32_t bucket_of(FixedTime time) const {
    return static_cast<std::uint32_t>(
        std::min(static_cast<double>(time) * per_tick_, static_cast<double>(last_)));
  }

  static constexpr Slot kEnd = kNoSlot - 1;  ///< behind the last bucket

  struct Entry {
    FixedTime time = 0;
    Slot next = kNoSlot;
    Slot before = kNoSlot;
    Slot bucket = kNoSlot;  ///< kNoSlot: not queued
  };

  std::vector<Slot> heads_;
  HugeVector<Entry> entries_;
  std::uint32_t last_ = 0;
  std::uint32_t present_ = 0;
  double per_tick_ = 1;
};

}  // namespace carom::event
