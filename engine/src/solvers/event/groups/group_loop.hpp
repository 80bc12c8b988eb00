#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "contact/impact_log.hpp"
#include "solvers/event/event_loop.hpp"
#include "solvers/event/groups/path.hpp"
#include "solvers/event/groups/window_book.hpp"

namespace carom::event {

/// One event loop over some of all balls, and the paths that they take in it.
///
/// Threads: one worker.
template <class P>
class GroupLoop {
 public:
  using Time = typename P::Time;
  using At = typename P::At;
  using Path = typename Paths<P>::Path;

  /// Whether impacts are noted.
  void note_impacts(bool wanted) { log_.wanted = wanted; }
  /// The balls that are solved next, its fixed balls among them, in any order; after `solve` each
  /// once, in order.
  [[nodiscard]] std::vector<Index>& members() { return members_; }
  /// Solves the members from `now` to `until`.  `first`: gives the Segment that a ball begins with.
  /// Balls keep their order; the fixed balls at which flights began are added.
  template <class First>
  void solve(const std::shared_ptr<const Motion<P>>& motion, std::size_t population, First first,
             At now, At until) {
    if (!loop_) loop_ = std::make_unique<EventLoop<P>>(motion, population);
    complete_members(first);
    flights_.clear();
    lefts_.clear();
    spins_.clear();
    begin_.clear();
    for (const Index i : members_) {
      const Segment<P>& segment = first(i);
      flights_.push_back(segment.flight);
      lefts_.push_back(slot_of(segment.left));
      spins_.push_back(segment.spin);
      begin_.push_back({segment.flight, lefts_.back(), segment.spin});
    }
    paths_.reset(begin_);
    loop_->record(&paths_);
    loop_->reset(flights_, now, lefts_, spins_);
    (void)loop_->take_counts();
    (void)loop_->take_lost();
    log_.impacts.clear();
    loop_->note_in(log_.wanted ? &log_ : nullptr);
    loop_->advance_to(until);
  }

  /// The path of member k.
  void copy_path(std::size_t k, Path& path) const {
    path.assign(paths_[k].begin(), paths_[k].end());
    path.back().left = loop_->left(static_cast<Index>(k));
    for (Segment<P>& segment : path) {
      if (segment.left != kUnknown) segment.left = members_[segment.left];
    }
  }
  [[nodiscard]] std::array<std::int64_t, 2> turns(std::size_t k) const {
    std::array<std::int64_t, 2> turns{0, 0};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!loop_->turns()[axis].empty()) turns[axis] = loop_->turns()[axis][k];
    }
    return turns;
  }
  /// What has happened to all of them.
  void take_outcome(WindowOutcome& outcome) {
    outcome.counts = loop_->take_counts();
    outcome.lost = loop_->take_lost();
    outcome.impacts = log_.impacts;
    for (Impact& impact : outcome.impacts) {
      impact.a = members_[impact.a];
      if (impact.b != Impact::kNoBall) impact.b = members_[impact.b];
    }
  }
  [[nodiscard]] Costs costs() const { return loop_ ? loop_->costs() : Costs{}; }

 private:
  template <class First>
  void complete_members(First first) {
    const std::size_t given = members_.size();
    for (std::size_t k = 0; k < given; ++k) {
      const Index fixed = first(members_[k]).left;
      if (fixed != kUnknown) members_.push_back(fixed);
    }
    std::sort(members_.begin(), members_.end());
    members_.erase(std::unique(members_.begin(), members_.end()), members_.end());
  }

  [[nodiscard]] Index slot_of(Index ball) const {
    if (ball == kUnknown) return kUnknown;
    const auto at = std::lower_bound(members_.begin(), members_.end(), ball);
    return static_cast<Index>(at - members_.begin());
  }

  std::unique_ptr<EventLoop<P>> loop_;
  std::vector<Index> members_;
  std::vector<Segment<P>> begin_;
  std::vector<typename P::Disk> flights_;
  std::vector<Index> lefts_;
  std::vector<typename P::Scalar> spins_;
  Paths<P> paths_;
  ImpactLog log_;
};

}  // namespace carom::event
