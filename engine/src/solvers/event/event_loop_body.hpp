#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/event/event_loop.hpp"

namespace carom::event {

template <class P>
EventLoop<P>::EventLoop(BasicRules<S> rules)
    : shared_motion_(std::make_shared<const Motion<P>>(std::move(rules))) {}

template <class P>
EventLoop<P>::EventLoop(std::shared_ptr<const Motion<P>> motion, std::size_t population)
    : shared_motion_(std::move(motion)), population_(population) {}

template <class P>
void EventLoop<P>::reset(const std::vector<Disk>& disks, At now, const std::vector<Index>& left,
                         const std::vector<S>& spins, const std::vector<double>& left_out) {
  spins_.clear();
  if (motion_.rules().spins) {
    spins_ = spins;
    spins_.resize(disks.size(), S(0));
  }
  left_ = left;
  const auto n = static_cast<Index>(disks.size());
  disks_.assign(disks.begin(), disks.end());
  bool fixed_disks = false;
  for (Disk& disk : disks_) {
    disk.meets = P::Clock::never();
    disk.leaves = P::Clock::never();
    disk.partner = kUnknown;
    if (motion_.fixed(disk)) {
      disk.start = P::Clock::ever();
      fixed_disks = true;
    }
  }
  if ((fixed_disks || motion_.rests()) && motion_.bends()) {
    left_.resize(n, kUnknown);
  } else {
    left_.clear();
  }
  left_out_.clear();
  if (motion_.contacts_last() && motion_.elastic()) {
    left_out_ = left_out;
    left_out_.resize(n, 0);
  }
  ties_.clear();
  impact_time_ = Time(-1);  // an impact at this very moment begins an instant
  jam_watch_.reset(now, std::max(population_, disks_.size()), motion_.elastic());
  step_clock_.reset(now);
  resolutions_.reset(n);
  before_.clear();
  pairs_.reset(n);
  changed_.clear();
  notes_.forget_slides();
  start_resting(now);
  ended_.reset(disks_, spins_);
  const Domain& domain = motion_.rules().domain;
  schedule_.reset(now, (domain.upper[0] - domain.lower[0]) * (domain.upper[1] - domain.lower[1]));
  if (motion_.rules().collisions) {
    neighbours_.reset(disks_, now);
    for (Index i = 0; i < n; ++i) disks_[i].leaves = neighbours_.leaving(disks_[i], i, now);
  }
  for (Index i = 0; i < n; ++i) predict(i, now);
  for (Index i = 0; i < n; ++i) schedule_.add(i);
}

template <class P>
void EventLoop<P>::take(const Entry& entry) {
  if (costs_.is_timed()) {
    time_event(entry.ball, entry.time);
  } else {
    next_event(entry.ball, entry.time);
  }
}

template <class P>
auto EventLoop<P>::first_event(At until) -> const Entry* {
  const auto prepare = [this](std::span<const Entry> entries, std::span<const Entry> next,
                              std::span<const Entry> after_next) {
    fetch(entries, next, after_next);
  };
  return schedule_.first(until, prepare);
}

template <class P>
void EventLoop<P>::advance_to(At until) {
  while (advance_to_step(until)) {
    begin_step();
    for (std::size_t k = 0; k < stepped_.size(); ++k) solve_island(k);
    end_step();
  }
}

template <class P>
bool EventLoop<P>::advance_to_step(At until) {
  for (;;) {
    const Time at = std::min(step_clock_.next(), Time(until));
    const Entry* next = first_event(at);
    const bool same = next != nullptr && next->time == impact_time_;
    if (!same && !pairs_.waiting().empty()) {
      resolve_waiting();
    } else if (!same && pairs_.any_pressed()) {
      settle_pressed();
    } else if (next != nullptr) {
      const Entry entry = *next;
      schedule_.drop_first();
      take(entry);
    } else if (step_clock_.next() <= until) {
      return true;
    } else {
      break;
    }
  }
  notes_.keep_slides();
  return false;
}

// Asks for the memory that the events of the next buckets will look at, in the order in which one
// needs the other, so that a hundred fetches run at once instead of one after the other.
template <class P>
void EventLoop<P>::fetch(std::span<const Entry> entries, std::span<const Entry> next,
                         std::span<const Entry> after_next) const {
  constexpr std::size_t kInCache = 4000;
  if (disks_.size() < kInCache || !motion_.rules().collisions) return;
  for (const Entry& entry : after_next) {
    __builtin_prefetch(&disks_[entry.ball]);
    neighbours_.fetch(entry.ball);
  }
  const auto meets_ball = [](const Disk& disk, const Entry& entry) {
    return disk.partner < kFirstMark && disk.meets == entry.time;
  };
  const auto fetch_listed = [this](Index i) {
    const auto& node = neighbours_.lists().first(i);
    for (std::uint32_t n = 0; n < node.count; ++n) __builtin_prefetch(&disks_[node.item[n]]);
  };
  for (const Entry& entry : next) {
    const Disk& disk = disks_[entry.ball];
    fetch_listed(entry.ball);
    if (meets_ball(disk, entry)) neighbours_.fetch(disk.partner);
    if (disk.leaves == entry.time) neighbours_.fetch_cells(entry.ball);
  }
  for (const Entry& entry : entries) {
    const Disk& disk = disks_[entry.ball];
    if (meets_ball(disk, entry)) fetch_listed(disk.partner);
    if (disk.leaves == entry.time) neighbours_.fetch_search(entry.ball);
  }
}

template <class P>
void EventLoop<P>::rebase(At by) {
  ended_.rebase(by);
  for (Disk& disk : disks_) {
    if (disk.start != P::Clock::ever()) disk.start -= by;
  }
  step_clock_.rebase(by);
  // Times of earlier epochs are only known to be earlier: their ticks do not fit into a number.
  jam_watch_.rebase(by);
  impact_time_ = impact_time_ >= by ? Time(impact_time_ - by) : Time(-1);
  before_.rebase(by);
  ties_.rebase(by);
  schedule_.rebase(by);
}

}  // namespace carom::event
