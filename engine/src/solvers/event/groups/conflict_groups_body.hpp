#pragma once

#include <algorithm>

#include "solvers/event/groups/conflict_groups.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

// Steps of contact islands in a window with a heap: with fewer the heap begins too often.
inline constexpr int kStepsOfHeap = 16;

template <class P>
ConflictGroups<P>::ConflictGroups(const BasicRules<S>& rules)
    : motion_(std::make_shared<const Motion<P>>(rules)),
      tracks_(motion_),
      workspaces_(1),
      region_pairs_(rules.domain) {}

template <class P>
void ConflictGroups<P>::reset(const std::vector<Disk>& flights, At now,
                              const std::vector<Index>& left, const std::vector<S>& spins) {
  now_ = now;
  until_ = now;
  target_ = now;
  listed_ = false;
  const auto& rules = motion_->rules();
  book_.reset(flights.size(), {rules.falls_round(0), rules.falls_round(1)});
  const double lost = tracks_.reset(flights, now, left, spins);
  if (lost != 0) book_.lose(lost);
  sets_.reset(tracks_.fixed());
  measure();
  length_.start_over();
}

template <class P>
void ConflictGroups<P>::measure() {
  const Spacing spacing = tracks_.spacing();
  margin_ = spacing.margin(motion_->rules().domain.period);
  length_.measure(spacing, motion_->rules().scale);
}

template <class P>
std::size_t ConflictGroups<P>::aim(At until) {
  target_ = until;
  if (!(now_ < target_)) return Phase::kFrameDone;
  return begin_window();
}

template <class P>
std::size_t ConflictGroups<P>::begin_window() {
  until_ = length_.end(now_, target_);
  cost_ = {};
  heap_ = false;
  first_pass_ = true;
  return kFly;
}

template <class P>
void ConflictGroups<P>::work(std::size_t phase, Share share) {
  switch (phase) {
    case kFly:
      fly(share);
      break;
    case kPairs:
      test_pairs(share);
      break;
    default:
      resolve(share);
  }
}

template <class P>
std::size_t ConflictGroups<P>::finish(std::size_t phase) {
  std::size_t next = after(phase);
  while (is_short(next)) {
    work(next, Share{});
    next = after(next);
  }
  return next;
}

template <class P>
std::size_t ConflictGroups<P>::after(std::size_t phase) {
  switch (phase) {
    case kFly:
      return after_flight();
    case kPairs:
      return merge();
    default:
      if (any_outside()) list_pairs();
      return kPairs;
  }
}

// To wake a worker takes some 3 microseconds, as to solve a ball, or to test its pairs, does.
template <class P>
bool ConflictGroups<P>::is_short(std::size_t phase) const {
  const bool again = phase == kPairs ? !first_pass_ : phase == kResolve && cost_.passes > 1;
  return again && to_solve_ <= workspaces_.size();
}

// --- the phases -------------------------------------------------------------------------------

// Each ball as if it were alone: most meet nothing, and their flights just go on.
template <class P>
void ConflictGroups<P>::fly(Share share) {
  Workspace& workspace = workspaces_[share.index];
  const Stopwatch stopwatch(true, workspace.wall_seconds);
  const std::vector<Index>& movers = tracks_.movers();
  const std::size_t end = share.end(movers.size());
  for (std::size_t k = share.begin(movers.size()); k < end; ++k) {
    const Index i = movers[k];
    tracks_.begin(i);
    if (tracks_.flies_on(i, until_)) {
      tracks_.set_box(i, now_, until_);
    } else {
      workspace.loop.members().assign(1, i);
      solve(i, workspace);
    }
    workspace.outside = workspace.outside || !tracks_.inside_region(i);
  }
}

template <class P>
void ConflictGroups<P>::test_pairs(Share share) {
  Workspace& workspace = workspaces_[share.index];
  const Stopwatch stopwatch(true, workspace.pair_seconds);
  const std::vector<RegionPair>& pairs = region_pairs_.pairs();
  const std::vector<double>& radii = tracks_.radii();
  const std::array<double, 2>& periods = motion_->rules().domain.period;
  const PathMeeting<P> paths(*motion_, until_);
  const bool joins_near = first_pass_ && merges_.joins_near();
  const double reach = joins_near ? MergeForecast::kReach : kWidest;
  const std::size_t end = share.end(pairs.size());
  for (std::size_t k = share.begin(pairs.size()); k < end; ++k) {
    const auto [i, j] = pairs[k];
    const Track& a = tracks_[i];
    const Track& b = tracks_[j];
    if (!first_pass_ && !a.changed && !b.changed) continue;
    if (!a.box.near(b.box, (radii[i] + radii[j]) * reach, periods)) continue;
    const PathBall one = tracks_.path_of(i);
    const PathBall other = tracks_.path_of(j);
    if (first_pass_ && paths.touch_at_start(one, other, now_)) workspace.touching.push_back({i, j});
    if (sets_.together(i, j)) continue;
    const bool lasting = paths.lasts(one, other);
    if (lasting || joins_near || paths.meet(one, other)) {
      workspace.encounters.push_back({i, j, lasting});
    }
  }
}

template <class P>
void ConflictGroups<P>::resolve(Share share) {
  Workspace& workspace = workspaces_[share.index];
  const std::size_t first = share.index + share.count - least_burdened_ % share.count;
  for (std::size_t k = first % share.count; k < dirty_.size(); k += share.count) {
    const Index root = dirty_[k].root;
    workspace.burden += dirty_[k].size;
    std::vector<Index>& members = workspace.loop.members();
    members = sets_.fixed_of(root);
    sets_.each(root, [&](Index i) { members.push_back(i); });
    solve(root, workspace);
  }
}

// From the flights that the balls begin the window with.
template <class P>
void ConflictGroups<P>::solve(Index root, Workspace& workspace) {
  GroupLoop<P>& loop = workspace.loop;
  loop.note_impacts(notes_);
  const auto first = [this](Index i) -> const Segment<P>& { return tracks_[i].first; };
  loop.solve(motion_, tracks_.size(), first, now_, until_);
  const std::vector<Index>& members = loop.members();
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Index i = members[k];
    if (tracks_.fixed()[i] != 0) continue;
    Track& track = tracks_[i];
    loop.copy_path(k, track.path);
    track.changed = true;
    track.outcome.clear();
    track.outcome.turns = loop.turns(k);
    workspace.solved.push_back(i);
    tracks_.set_box(i, now_, until_);
    workspace.outside = workspace.outside || !tracks_.inside_region(i);
  }
  loop.take_outcome(tracks_[root].outcome);
}

// --- between two phases -----------------------------------------------------------------------

template <class P>
std::size_t ConflictGroups<P>::after_flight() {
  if (!motion_->rules().collisions) return end_window();
  sets_.begin_window();
  if (!listed_ || any_outside()) list_pairs();
  return kPairs;
}

template <class P>
bool ConflictGroups<P>::any_outside() const {
  return std::any_of(workspaces_.begin(), workspaces_.end(),
                     [](const Workspace& workspace) { return workspace.outside; });
}

template <class P>
void ConflictGroups<P>::list_pairs() {
  tracks_.set_regions(margin_);
  measure();
  region_pairs_.build(tracks_.regions(), tracks_.radii(), tracks_.fixed(), kWidest);
  listed_ = true;
  for (Workspace& workspace : workspaces_) workspace.outside = false;
}

// The largest group is solved by who has had least to solve so far, or one worker would have most
// of the work where a heap is one group.
template <class P>
void ConflictGroups<P>::take_turns() {
  const auto has_less = [](const Workspace& a, const Workspace& b) { return a.burden < b.burden; };
  const auto least = std::min_element(workspaces_.begin(), workspaces_.end(), has_less);
  least_burdened_ = static_cast<std::size_t>(least - workspaces_.begin());
}

// Groups that meet become one; what has changed since the last pass has been looked at.
template <class P>
std::size_t ConflictGroups<P>::merge() {
  sets_.begin_pass();
  for (Workspace& workspace : workspaces_) {
    sets_.touch(workspace.touching);
    workspace.touching.clear();
    for (const Index i : workspace.solved) tracks_[i].changed = false;
  }
  for (Workspace& workspace : workspaces_) {
    sets_.meet(workspace.encounters);
    workspace.encounters.clear();
  }
  first_pass_ = false;
  ++cost_.passes;
  dirty_ = sets_.joined();
  to_solve_ = 0;
  for (const ConflictSets::Group& group : dirty_) {
    to_solve_ += group.size;
    // Shorter windows part what meets, not what stays together.
    if (!group.lasting) cost_.solved += group.size;
    if (group.lasting && cost_.passes > 1) merges_.add_solved_again(group.size);
    heap_ = heap_ || (group.lasting && 2 * group.size > tracks_.movers().size());
    largest_ = std::max(largest_, group.size);
    sets_.each(group.root, [this](Index i) { tracks_[i].outcome.clear(); });
  }
  if (dirty_.empty()) return end_window();
  take_turns();
  return kResolve;
}

template <class P>
std::size_t ConflictGroups<P>::end_window() {
  for (Workspace& workspace : workspaces_) {
    for (const Index i : workspace.solved) {
      book_.enter(i, tracks_[i].outcome);
      tracks_[i].changed = false;
      sets_.forget(i);
    }
    workspace.solved.clear();
  }
  now_ = until_;
  ++windows_;
  passes_ += cost_.passes;
  length_.learn(cost_, tracks_.movers().size());
  // One worker has most of such a window: the next one is another worker's.
  if (heap_ && workspaces_.size() > 1) {
    length_.shorten_to(P::Clock::span(kStepsOfHeap, motion_->step_shift()));
  }
  merges_.end_window(tracks_.movers().size());
  if (now_ == target_) return Phase::kFrameDone;
  return begin_window();
}

// --- looking ----------------------------------------------------------------------------------

template <class P>
void ConflictGroups<P>::rebase(At by) {
  tracks_.rebase(by);
  const Time& shift = by;
  now_ -= shift;
  until_ -= shift;
  target_ -= shift;
}

template <class P>
Costs ConflictGroups<P>::costs() const {
  Costs costs;
  for (const Workspace& workspace : workspaces_) {
    costs += workspace.loop.costs();
    costs.collisions += workspace.pair_seconds;
    costs.walls += workspace.wall_seconds;
  }
  return costs;
}

}  // namespace carom::event
