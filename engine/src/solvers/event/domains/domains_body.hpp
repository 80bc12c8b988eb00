#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/event/domains/domains.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

// Of several domains, whose halos it makes wide: how far the fastest ball may go, in spacings.
inline constexpr double kFarthest = 1.4;
// No more share the sorting of flights.
inline constexpr std::size_t kMostSorters = 16;
// Windows solved by an event loop count so much more than others; with so many, domains do not pay.
inline constexpr std::uint32_t kOddWindow = 8;
inline constexpr std::uint32_t kTooManyOdd = 64;

template <class P>
void Domains<P>::set_workers(std::size_t workers) {
  if (workers == workers_) return;
  if (open_) close_window();
  workers_ = workers;
  workspaces_.resize(workers);
  const double before = collisions_of_window();
  decompose();
  window_ =
      static_cast<FixedTime>(static_cast<double>(window_) * (collisions_of_window() / before));
  limit_window();
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
  // One domain alone may look beyond the aim.
  full_ = alone() || window_ <= target_ - now_;
  until_ = full_ ? now_ + window_ : target_;
  to_solve_.resize(regions_.size());
  for (std::size_t k = 0; k < regions_.size(); ++k) to_solve_[k] = k;
  taken_ = 0;
  outcomes_.resize(alone() ? 0 : next_.size());
  block_of_.resize(alone() ? 0 : next_.size());
  flights_.resize(next_.size());
  spins_.resize(next_spins_.size());
  if (alone()) {
    flights_.swap(next_);
    spins_.swap(next_spins_);
    next_.resize(flights_.size());
    next_spins_.resize(spins_.size());
    return kSolve;
  }
  counted_ = false;
  return kSort;
}

template <class P>
void Domains<P>::work(std::size_t phase, Share share) {
  Workspace& workspace = workspaces_[share.index];
  if (phase == kSort) {
    if (share.index >= kMostSorters) return;
    const Stopwatch stopwatch(true, workspace.seconds);
    share.count = std::min(share.count, kMostSorters);
    if (counted_) {
      scatter(share);
    } else {
      count_blocks(share);
    }
    return;
  }
  const Stopwatch stopwatch(true, workspace.seconds);
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
      find_large();
      return kSolve;
    }
    place_blocks();
    counted_ = true;
    return kSort;
  }
  if (by_one_loop_) {
    by_one_loop_ = false;
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
void Domains<P>::solve_alone(Workspace& workspace) {
  Region& region = regions_[0];
  if (!workspace.domain)
    workspace.domain = std::make_unique<DomainLoop<P>>(*motion_, normal_radius_);
  DomainLoop<P>& domain = *workspace.domain;
  if (!open_) {
    DomainWindow window = window_of(region);
    domain.begin(window, flights_.data(), spins_.empty() ? nullptr : spins_.data());
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
  adapt(static_cast<double>(domain.tally().ball_halves));
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

// The next window is as long as collisions take of which a ball has some.
template <class P>
void Domains<P>::adapt(double halves) {
  const auto span = static_cast<double>(until_ - from_);
  const double wanted = collisions_of_window() * static_cast<double>(movers_);
  if (!(span > 0)) return;
  const double many = std::max(halves, wanted / 4);
  const double length = std::clamp(span * wanted / many, static_cast<double>(window_) / 2,
                                   static_cast<double>(window_) * 2);
  const double share = full_ ? 0.5 : 0.1;  // in a short time few balls collide by chance
  window_ += static_cast<FixedTime>(share * (length - static_cast<double>(window_)));
  limit_window();
}

template <class P>
void Domains<P>::limit_window() {
  FixedTime most = longest_;
  if (!alone() && speed_ > 0) {
    most = std::min(most, motion_->rules().scale.ticks(kFarthest * spacing_ / speed_));
  }
  window_ = std::min(std::max<FixedTime>(window_, 64), std::max<FixedTime>(most, 1));
}

template <class P>
void Domains<P>::solve_by_one_loop() {
  blocks_known_ = false;
  const std::size_t n = flights_.size();
  std::vector<Disk> disks(n);
  for (std::size_t k = 0; k < n; ++k) disks[k] = flights_[k].disk();
  EventLoop<P> loop(motion_, n);
  loop.reset(disks, from_, {}, spins_);
  loop.advance_to(until_);
  for (std::size_t k = 0; k < n; ++k) {
    next_[k] = BlockFlight::of(loop.disks()[k], flights_[k].ball);
  }
  if (!spins_.empty()) next_spins_ = loop.spins();
  counts_ += loop.counts();
  // What drag takes follows from the time alone, and nothing else loses energy beside it.
  if (motion_->rules().drag_rate > 0) return;
  for (const double lost : loop.take_lost()) lost_.add(lost);
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

template <class P>
void Domains<P>::number_balls() const {
  if (!memory_.empty()) return;
  memory_.resize(next_.size());
  const DomainLoop<P>* domain = open_ ? workspaces_[0].domain.get() : nullptr;
  for (std::size_t k = 0; k < next_.size(); ++k) {
    const Index ball = domain != nullptr ? flights_[domain->memory(k)].ball : next_[k].ball;
    memory_[ball] = static_cast<Index>(k);
  }
}

template <class P>
auto Domains<P>::flight(std::size_t ball) const -> Disk {
  number_balls();
  const Index k = memory_[ball];
  return (open_ ? workspaces_[0].domain->flight(k) : next_[k]).disk();
}

template <class P>
double Domains<P>::spin(std::size_t ball) const {
  number_balls();
  const Index k = memory_[ball];
  return open_ ? *workspaces_[0].domain->spin(k) : next_spins_[k];
}

template <class P>
Counts Domains<P>::counts() const {
  Counts counts = counts_;
  std::uint64_t halves = halves_;
  if (open_) {
    const auto& tally = workspaces_[0].domain->tally();
    halves += tally.ball_halves;
    counts.ball_wall += tally.walls;
    counts.max_overlap = std::max(counts.max_overlap, tally.max_overlap);
  }
  counts.ball_ball += halves / 2;
  return counts;
}

template <class P>
std::vector<double> Domains<P>::losses() const {
  ExactSum<double> sum = lost_;
  if (open_) {
    for (const double lost : workspaces_[0].domain->tally().lost) sum.add(lost);
  }
  return sum.parts();
}

template <class P>
Costs Domains<P>::costs() const {
  Costs costs;
  for (const Workspace& workspace : workspaces_) {
    costs += workspace.beside_pairs;
    costs.collisions += workspace.seconds - workspace.beside_pairs.beside_pairs();
  }
  if (open_) {
    const Costs& open = workspaces_[0].domain->tally().costs;
    costs += open;
    costs.collisions -= open.beside_pairs();
  }
  costs.collisions = std::max(costs.collisions, 0.0);
  return costs;
}

template <class P>
std::size_t Domains<P>::bytes() const {
  std::size_t bytes =
      (flights_.capacity() + next_.capacity()) * sizeof(BlockFlight) +
      (spins_.capacity() + next_spins_.capacity()) * sizeof(double) +
      outcomes_.capacity() * sizeof(Outcome) +
      (block_of_.capacity() + starts_.capacity() + memory_.capacity()) * sizeof(Index);
  for (const Region& region : regions_) bytes += region.ghosts.capacity() * sizeof(Ghost);
  for (const Workspace& workspace : workspaces_) {
    bytes += workspace.counts.capacity() * sizeof(Index);
    if (workspace.domain) bytes += workspace.domain->bytes();
  }
  return bytes;
}

}  // namespace carom::event
