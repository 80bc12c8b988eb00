#pragma once

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "solvers/event/event_loop.hpp"
#include "solvers/event/order_by_place.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

// Contact islands in the order of time: they are found, change, are booked, and fly on.

template <class P>
bool EventLoop<P>::is_hit_of_island(Index i, Index partner, At now) const {
  if (motion_.in_island(disks_[i])) return true;
  if (partner >= kFirstMark) return false;
  const Disk& other = disks_[partner];
  if (!motion_.fixed(other) && motion_.in_island(other)) return true;
  const Vec<S> r = motion_.way(motion_.place(disks_[i], now), motion_.place(other, now));
  return motion_.sticks(disks_[i], other, r, now);
}

// Balls that meet something at one instant; those of one island are resolved together. All are
// found before any is resolved.
template <class P>
void EventLoop<P>::hit_islands(const std::vector<std::vector<Index>>& hits, At now) {
  if (hits.empty()) return;
  const Stopwatch stopwatch(true, costs_.island_seconds());
  schedule_step(now);
  SteppedFlight next;
  if (step_clock_.runs()) next = motion_.stepped_flight(now, step_clock_.next());
  for (FoundIsland& island : island_search_.of_hits(hits, now)) {
    resolutions_.begin();
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      if (island.touches[k] == 0) continue;
      const ConeContact& c = island.contacts[k];
      const Index other =
          c.b == kWall ? island.near[k].partner : island.members[static_cast<std::size_t>(c.b)];
      pairs_.note_resolved(island.members[static_cast<std::size_t>(c.a)], other);
    }
    IslandChange change = island_impact_.resolve(island, next, now);
    change.carried.lost = island_impulses_.energy().hold(island, change.carried.lost);
    take_on(island, change, now);
    resolutions_.end();
  }
}

template <class P>
void EventLoop<P>::begin_step() {
  const Stopwatch stopwatch(true, costs_.island_seconds());
  step_time_ = step_clock_.next();
  step_clock_.take();
  std::vector<Index> all;
  for (Index i = 0; i < disks_.size(); ++i) {
    if (!motion_.fixed(disks_[i]) && motion_.support(disks_[i]) >= kStepped) all.push_back(i);
  }
  const Time next = step_time_ + P::Clock::span(1, motion_.step_shift());
  stepped_.clear();
  for (FoundIsland& island : island_search_.of_step(all, step_time_, next)) {
    stepped_.push_back({std::move(island), {}, 0});
  }
}

// It reads the flights, and changes nothing but the island.
template <class P>
void EventLoop<P>::solve_island(std::size_t k) {
  auto& [island, change, seconds] = stepped_[k];
  const Stopwatch stopwatch(true, seconds);
  const bool hit = std::any_of(island.near.begin(), island.near.end(),
                               [](const auto& near) { return near.comes; });
  if (hit) {
    change = island_impact_.resolve(island, motion_.whole_flight(), step_time_, true);
  } else {
    step_island(island, change);
  }
  change.carried.lost = island_impulses_.energy().hold(island, change.carried.lost);
}

template <class P>
void EventLoop<P>::step_island(FoundIsland& island, IslandChange& change) const {
  FoundIsland before;
  if (motion_.keeps_energy()) before = island;
  const auto number = P::Clock::steps(step_time_, motion_.step_shift());
  change = island_stepping_.step(island, number % kAskedAgain == 0);
  if (change.counts.jammed == 0) return;
  IslandChange turned = island_impact_.turn(before, change, step_time_);
  if (turned.counts.jammed > 0 && std::abs(turned.carried.lost) >= std::abs(change.carried.lost))
    return;
  island = std::move(before);
  change = std::move(turned);
}

template <class P>
void EventLoop<P>::end_step() {
  const Stopwatch stopwatch(true, costs_.island_seconds());
  resolutions_.begin();
  for (const Stepped& island : stepped_) {
    costs_.island_seconds() += island.seconds;
    take_on(island.found, island.change, step_time_);
  }
  stepped_.clear();
  begin_simultaneous();  // what comes now takes no step back
  predict_changed(step_time_);
}

template <class P>
void EventLoop<P>::take_on(const FoundIsland& island, const IslandChange& change, At now) {
  counts_ += change.counts;
  counts_.max_overlap = std::max(counts_.max_overlap, island.deepest);
  if (notes_.wanted()) {
    for (const Index i : change.woken) writer_.wake(i, now);
  }
  const std::size_t first_line = notes_.lines();
  if (notes_.wanted()) writer_.island(island, change.carried, now);
  book_.correct(change.carried.lost);
  notes_.tell_loss(first_line, fly_on(island, now));
}

template <class P>
double EventLoop<P>::fly_on(const FoundIsland& island, At now) {
  bool moves = false;
  const bool large = !motion_.elastic() && is_large(island);
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    const Index i = island.members[m];
    Disk& disk = disks_[i];
    if (large && island.support[m] == kResting && stands(disk, island.places[m])) continue;
    remember(i);
    schedule_.unlink(i);
    schedule_.forget(i);
    disk.x = island.places[m].x;
    disk.y = island.places[m].y;
    disk.vx = with_plain_zero(island.bodies[m].velocity.x);
    disk.vy = with_plain_zero(island.bodies[m].velocity.y);
    if (!spins_.empty()) spins_[i] = island.bodies[m].turning / motion_.species(disk).radius;
    disk.start = now;
    motion_.set_support(disk, island.support[m]);
    left_[i] = kUnknown;
    if (!left_out_.empty()) left_out_[i] = island.left_out[m];
    moves = moves || island.support[m] == kStepped;
    changed_.push_back(i);
  }
  // Of several fixed balls that it touches, the one that lies first, by place.
  std::vector<const Vec<S>*> ways(island.members.size(), nullptr);
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const auto a = static_cast<std::size_t>(island.contacts[k].a);
    const auto& near = island.near[k];
    if (island.support[a] >= kResting || island.touches[k] == 0 || near.partner >= kFirstMark)
      continue;
    if (ways[a] != nullptr && precedes_by_place(*ways[a], near.r)) continue;
    ways[a] = &near.r;
    left_[island.members[a]] = near.partner;
  }
  if (moves) schedule_step(now);
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    if (island.support[m] < kResting) supports_.update(island.members[m]);
  }
  return book_.keep();
}

}  // namespace carom::event
