#pragma once

#include <algorithm>
#include <vector>

#include "solvers/event/event_loop.hpp"

namespace carom::event {

// What is resolved alone, and then found to share a ball with more, is taken back, and nothing
// else.

template <class P>
void EventLoop<P>::begin_simultaneous() {
  resolutions_.begin_instant();
  before_.clear();
  pairs_.forget_resolved();
  notes_.keep_slides();
}

template <class P>
void EventLoop<P>::remember(Index i) {
  if (motion_.fixed(disks_[i]) || !resolutions_.add(i)) return;
  before_.add({i, disks_[i], spins_.empty() ? S(0) : spins_[i], left(i), left_out(i)});
}

template <class P>
void EventLoop<P>::take_back(std::vector<Index>& balls) {
  const auto add = [&balls](Index k) {
    if (std::find(balls.begin(), balls.end(), k) == balls.end()) balls.push_back(k);
  };
  const Resolutions::Chosen chosen = resolutions_.with(balls);
  const auto is_undone = [&](Index k) { return moves(k) && resolutions_.contains(chosen, k); };
  for (const Pair& pair : pairs_.take_back(is_undone)) {
    for (const Index k : {pair.first, pair.second}) {
      if (moves(k)) add(k);
    }
  }
  before_.take_back(is_undone, [&](const typename FlightsBefore<P>::Before& before) {
    const Index k = before.ball;
    add(k);
    schedule_.unlink(k);
    const Time leaves = disks_[k].leaves;
    disks_[k] = before.disk;
    disks_[k].leaves = leaves;
    if (!spins_.empty()) spins_[k] = before.spin;
    if (!left_.empty()) left_[k] = before.left;
    if (!left_out_.empty()) left_out_[k] = before.left_out;
    schedule_.forget(k);
  });
  resolutions_.take_back(chosen);
}

}  // namespace carom::event
