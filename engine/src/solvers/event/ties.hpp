#pragma once

#include <set>
#include <utility>

#include "solvers/event/disk.hpp"

namespace carom::event {

/// Balls, and times at which they may have more than one impact, as was seen when their next one
/// was looked for.
///
/// Holds: a tie may be of a flight that is over; one that was seen is there until its time has
/// passed.
template <class Clock>
class Ties {
 public:
  using Time = typename Clock::Time;
  using At = typename Clock::At;

  void clear() { ties_.clear(); }
  void note(At at, Index i) { ties_.emplace(at, i); }
  /// Whether one is noted of either ball at `now`.  Forgets those of before.
  /// REQUIRES: `now` is not before that of an earlier call.
  [[nodiscard]] bool any(At now, Index i, Index j) {
    if (ties_.empty()) return false;
    ties_.erase(ties_.begin(), ties_.lower_bound({now, 0}));
    return ties_.count({now, i}) > 0 || ties_.count({now, j}) > 0;
  }
  /// Counts time from `by` ticks later on; ties of before are forgotten.
  void rebase(At by) {
    std::set<std::pair<Time, Index>> ties;
    for (auto at = ties_.lower_bound({by, 0}); at != ties_.end(); ++at) {
      ties.emplace(at->first - by, at->second);
    }
    ties_ = std::move(ties);
  }

 private:
  std::set<std::pair<Time, Index>> ties_;
};

}  // namespace carom::event
