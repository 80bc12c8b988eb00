#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/event/domains/domains.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

// Windows solved by an event loop count so much more than others; with so many, domains do not pay.
inline constexpr std::uint32_t kOddWindow = 8;
inline constexpr std::uint32_t kTooManyOdd = 64;

template <class P>
void Domains<P>::set_workers(std::size_t workers) {
  if (workers == workers_) return;
  if (open_) close_window();
  workers_ = workers;
  workspaces_.resize(workers);
  decompose();
}

template <class P>
std::size_t Domains<P>::aim(FixedTime until) {
  target_ = until;
  if (!(now_ < target_)) return Phase::kFrameDone;
  return open_ ? std::size_t{kSolve} : begin_window();
}

template <class P>
std::size_t Domains<P>::begin_window() {
  memory_.clear();
  from_ = now_;
  by_one_loop_ = false;
  until_ = span_.end(now_, target_);
  to_solve_.resize(regions_.size());
  for (std::size_t k = 0; k < regions_.size(); ++k) to_solve_[k] = k;
  taken_ = 0;
  outcomes_.resize(alone() ? 0 : next_.size());
  sort_.make_room(alone() ? 0 : next_.size());
  flights_.resize(next_.size());
  spins_.resize(next_spins_.size());
  lefts_.resize(next_lefts_.size());
  if (alone()) {
    flights_.swap(next_);
    spins_.swap(next_spins_);
    lefts_.swap(next_lefts_);
    next_.resize(flights_.size());
    next_spins_.resize(spins_.size());
    next_lefts_.resize(lefts_.size());
    return kSolve;
  }
  counted_ = false;
  return kSort;
}

template <class P>
void Domains<P>::work(std::size_t phase, Share share) {
  Workspace& workspace = workspaces_[share.index];
  const Stopwatch stopwatch(true, workspace.seconds);
  if (phase == kSort) {
    if (counted_) {
      scatter(share);
    } else {
      sort_.count(*motion_, *blocks_, next_, now_, share);
    }
    return;
  }
  if (by_one_loop_) {
    if (share.index == 0) solve_by_one_loop();
  } else if (alone()) {
    if (share.index == 0) solve_alone(workspace);
  } else if (phase == kSolve) {
    for (std::size_t k = taken_++; k < to_solve_.size(); k = taken_++) {
      solve(regions_[to_solve_[k]], workspace);
    }
  } else {
    for (std::size_t k = share.index; k < regions_.size(); k += share.count) check(regions_[k]);
  }
}

template <class P>
std::size_t Domains<P>::finish(std::size_t phase) {
  if (phase == kSort) {
    if (counted_) {
      sort_.find_large(*motion_, flights_, normal_radius_);
      return kSolve;
    }
    sort_.place_blocks();
    counted_ = true;
    return kSort;
  }
  if (by_one_loop_) {
    by_one_loop_ = false;
    stuck_ = any_rests();
    return end_window();
  }
  if (phase == kCheck) return judge();
  bool unusual = false;
  for (const std::size_t k : to_solve_) unusual = unusual || regions_[k].unusual;
  if (unusual) {
    by_one_loop_ = true;
    open_ = false;
    memory_.clear();
    until_ = std::min(until_, target_);
    odd_windows_ += kOddWindow;
    return kSolve;
  }
  if (!alone()) return kCheck;
  now_ = std::min(until_, target_);
  if (now_ < until_) return Phase::kFrameDone;
  close_window();
  return end_window();
}

template <class P>
std::size_t Domains<P>::end_window() {
  now_ = until_;
  ++windows_;
  if (odd_windows_ > kTooManyOdd) stuck_ = true;
  if (odd_windows_ > 0) --odd_windows_;
  return now_ < target_ && !stuck_ ? begin_window() : Phase::kFrameDone;
}

template <class P>
auto Domains<P>::memory_of_domains() const -> typename DomainLoop<P>::Memory {
  return {flights_.data(), spins_.empty() ? nullptr : spins_.data(),
          lefts_.empty() ? nullptr : lefts_.data()};
}

template <class P>
void Domains<P>::solve_alone(Workspace& workspace) {
  Region& region = regions_[0];
  if (!workspace.domain)
    workspace.domain = std::make_unique<DomainLoop<P>>(*motion_, normal_radius_);
  DomainLoop<P>& domain = *workspace.domain;
  if (!open_) {
    DomainWindow window = window_of(region);
    domain.begin(window, memory_of_domains());
    for (std::size_t k = 0; k < flights_.size(); ++k) domain.load(static_cast<Index>(k), true);
    region.unusual = !domain.start();
    open_ = !region.unusual;
  }
  if (open_) region.unusual = !domain.advance_to(std::min(until_, target_));
}

// One domain: what it has come to goes on as flights.
template <class P>
void Domains<P>::close_window() {
  DomainLoop<P>& domain = *workspaces_[0].domain;
  until_ = now_;
  keep(regions_[0], domain);
  add_tally(domain.tally());
  workspaces_[0].beside_pairs += domain.tally().costs;
  span_.learn(static_cast<double>(domain.tally().ball_halves), until_ - from_);
  open_ = false;
  memory_.clear();
}

template <class P>
void Domains<P>::add_tally(const typename DomainLoop<P>::Tally& tally) {
  halves_ += tally.ball_halves;
  counts_.ball_wall += tally.walls;
  counts_.predictions += tally.predictions;
  counts_.renewals += tally.renewals;
  counts_.stale += tally.stale;
  counts_.max_overlap = std::max(counts_.max_overlap, tally.max_overlap);
  for (const double lost : tally.lost) lost_.add(lost);
}

template <class P>
void Domains<P>::scatter(Share share) {
  sort_.scatter(next_.size(), share, [this](std::size_t k, Index at) {
    flights_[at] = next_[k];
    if (!spins_.empty()) spins_[at] = next_spins_[k];
    if (!lefts_.empty()) lefts_[at] = next_lefts_[k];
  });
}

template <class P>
void Domains<P>::solve_by_one_loop() {
  sort_.set_known(false);
  const std::size_t n = flights_.size();
  std::vector<Disk> disks(n);
  for (std::size_t k = 0; k < n; ++k) disks[k] = flights_[k].disk();
  std::vector<Index> lefts(lefts_.size(), kUnknown);
  if (!lefts_.empty()) {
    std::vector<Index> at(n);
    for (std::size_t k = 0; k < n; ++k) at[flights_[k].ball] = static_cast<Index>(k);
    for (std::size_t k = 0; k < n; ++k) {
      if (lefts_[k] != kUnknown) lefts[k] = at[lefts_[k]];
    }
  }
  EventLoop<P> loop(motion_, n);
  loop.reset(disks, from_, lefts, spins_);
  loop.advance_to(until_);
  for (std::size_t k = 0; k < lefts.size(); ++k) {
    const Index left = loop.left(static_cast<Index>(k));
    next_lefts_[k] = left == kUnknown ? kUnknown : flights_[left].ball;
  }
  for (std::size_t k = 0; k < n; ++k) {
    next_[k] = BlockFlight::of(loop.disks()[k], flights_[k].ball);
  }
  if (!spins_.empty()) next_spins_ = loop.spins();
  counts_ += loop.counts();
  if (motion_->rules().only_drag_takes()) return;
  for (const double lost : loop.take_lost()) lost_.add(lost);
}

template <class P>
bool Domains<P>::any_rests() const {
  if (!motion_->contacts_last()) return false;
  return std::any_of(next_.begin(), next_.end(), [this](const BlockFlight& flight) {
    return !motion_->fixed(flight) && !motion_->flies(flight);
  });
}

template <class P>
void Domains<P>::rebase(FixedTime by) {
  if (open_) close_window();
  now_ -= by;
  from_ -= by;
  until_ -= by;
  target_ -= by;
  for (BlockFlight& flight : next_) {
    if (flight.start != kEver) flight.start -= by;
  }
}

}  // namespace carom::event
