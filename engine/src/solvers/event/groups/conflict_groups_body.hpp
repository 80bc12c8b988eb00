#pragma once

#include <algorithm>

#include "solvers/event/groups/conflict_groups.hpp"
#include "solvers/event/groups/path_box.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

template <class P>
ConflictGroups<P>::ConflictGroups(const BasicRules<S>& rules)
    : motion_(std::make_shared<const Motion<P>>(rules)),
      workspaces_(1),
      region_pairs_(rules.domain) {}

template <class P>
void ConflictGroups<P>::reset(const std::vector<Disk>& flights, At now,
                              const std::vector<Index>& left, const std::vector<S>& spins) {
  const std::size_t n = flights.size();
  now_ = now;
  until_ = now;
  target_ = now;
  tracks_.assign(n, {});
  fixed_.assign(n, 0);
  radii_.resize(n);
  regions_.resize(n);
  movers_.clear();
  listed_ = false;
  const auto& rules = motion_->rules();
  book_.reset(n, {rules.falls_round(0), rules.falls_round(1)});
  double supported_loss = 0;
  for (std::size_t i = 0; i < n; ++i) {
    supported_loss +=
        take(i, {flights[i], left.empty() ? kUnknown : left[i], spins.empty() ? S(0) : spins[i]});
  }
  if (supported_loss != 0) book_.lose(supported_loss);
  sets_.reset(fixed_);
  measure();
  length_.start_over();
}

// Gives what walls take at once from a ball that begins now and that they support.
template <class P>
double ConflictGroups<P>::take(std::size_t ball, Segment<P> segment) {
  Disk& flight = segment.flight;
  double lost = 0;
  radii_[ball] = static_cast<double>(motion_->species(flight).radius);
  if (motion_->fixed(flight)) {
    fixed_[ball] = 1;
    flight.start = P::Clock::ever();
  } else {
    movers_.push_back(static_cast<Index>(ball));
    const unsigned support = motion_->support(flight);
    if (motion_->contacts_last() && support != kLying && support < kResting &&
        flight.start == now_) {
      S* spin = motion_->rules().spins ? &segment.spin : nullptr;
      lost = std::max(motion_->support_on_walls(flight, spin), 0.0);
    }
  }
  tracks_[ball].first = segment;
  tracks_[ball].path.push_back(segment);
  set_box(static_cast<Index>(ball));
  return lost;
}

template <class P>
void ConflictGroups<P>::measure() {
  double speeds = 0;
  double diameters = 0;
  for (const Index i : movers_) {
    const Disk& disk = flight(i);
    const auto x = static_cast<double>(disk.vx);
    const auto y = static_cast<double>(disk.vy);
    speeds += x * x + y * y;
    diameters += 2 * radii_[i];
  }
  const auto& rules = motion_->rules();
  const Spacing spacing(movers_.size(), speeds, diameters, rules.domain, rules.gravity);
  margin_ = spacing.margin(rules.domain.period);
  length_.measure(spacing, rules.scale);
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

// --- the phases -------------------------------------------------------------------------------

// Each ball as if it were alone: most meet nothing, and their flights just go on.
template <class P>
void ConflictGroups<P>::fly(Share share) {
  Workspace& workspace = workspaces_[share.index];
  const Stopwatch stopwatch(true, workspace.wall_seconds);
  workspace.outside = false;
  const std::size_t end = share.end(movers_.size());
  for (std::size_t k = share.begin(movers_.size()); k < end; ++k) {
    const Index i = movers_[k];
    Track& track = tracks_[i];
    // The window begins with the flight that the one before has ended with.
    track.first = track.path.back();
    track.path.assign(1, track.first);
    if (flies_on(track.first)) {
      set_box(i);
    } else {
      workspace.loop.members().assign(1, i);
      solve(i, workspace);
    }
    workspace.outside = workspace.outside || !inside_region(i);
  }
}

template <class P>
bool ConflictGroups<P>::flies_on(const Segment<P>& segment) const {
  if (motion_->support(segment.flight) >= kStepped) return false;
  const S* spin = motion_->rules().spins ? &segment.spin : nullptr;
  return motion_->alone(segment.flight, until_, spin).time > until_;
}

template <class P>
void ConflictGroups<P>::test_pairs(Share share) {
  Workspace& workspace = workspaces_[share.index];
  const Stopwatch stopwatch(true, workspace.pair_seconds);
  workspace.encounters.clear();
  workspace.touching.clear();
  const std::vector<RegionPair>& pairs = region_pairs_.pairs();
  const std::array<double, 2>& periods = motion_->rules().domain.period;
  const PathMeeting<P> paths(*motion_, until_);
  const std::size_t end = share.end(pairs.size());
  for (std::size_t k = share.begin(pairs.size()); k < end; ++k) {
    const auto [i, j] = pairs[k];
    const Track& a = tracks_[i];
    const Track& b = tracks_[j];
    if (!first_pass_ && !a.changed && !b.changed) continue;
    if (!a.box.near(b.box, (radii_[i] + radii_[j]) * kWidest, periods)) continue;
    const PathBall one = path_of(i);
    const PathBall other = path_of(j);
    if (first_pass_ && paths.touch_at_start(one, other, now_)) workspace.touching.push_back({i, j});
    if (sets_.together(i, j)) continue;
    const bool lasting = paths.lasts(one, other);
    if (lasting || paths.meet(one, other)) workspace.encounters.push_back({i, j, lasting});
  }
}

template <class P>
void ConflictGroups<P>::resolve(Share share) {
  Workspace& workspace = workspaces_[share.index];
  workspace.outside = false;
  for (std::size_t k = share.index; k < dirty_.size(); k += share.count) {
    const Index root = dirty_[k].root;
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
    if (fixed_[i] != 0) continue;
    Track& track = tracks_[i];
    loop.copy_path(k, track.path);
    track.changed = true;
    track.outcome.clear();
    track.outcome.turns = loop.turns(k);
    workspace.solved.push_back(i);
    set_box(i);
    workspace.outside = workspace.outside || !inside_region(i);
  }
  loop.take_outcome(tracks_[root].outcome);
}

template <class P>
void ConflictGroups<P>::set_box(Index ball) {
  Track& track = tracks_[ball];
  track.box = fixed_[ball] != 0 ? box_of_fixed<P>(track.path.front().flight)
                                : box_of_path<P>(*motion_, track.path, now_, until_);
}

template <class P>
bool ConflictGroups<P>::inside_region(Index ball) const {
  return regions_[ball].contains(tracks_[ball].box, motion_->rules().domain.period);
}

template <class P>
typename ConflictGroups<P>::PathBall ConflictGroups<P>::path_of(Index ball) const {
  return {ball, fixed_[ball] != 0, tracks_[ball].path};
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
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    regions_[i] = tracks_[i].box;
    if (fixed_[i] != 0) continue;
    for (double& half : regions_[i].half) half += margin_;
  }
  measure();
  region_pairs_.build(regions_, radii_, fixed_, kWidest);
  listed_ = true;
}

// Groups that meet become one; what has changed since the last pass has been looked at.
template <class P>
std::size_t ConflictGroups<P>::merge() {
  sets_.begin_pass();
  for (const Workspace& workspace : workspaces_) {
    sets_.touch(workspace.touching);
    for (const Index i : workspace.solved) tracks_[i].changed = false;
  }
  for (const Workspace& workspace : workspaces_) sets_.meet(workspace.encounters);
  first_pass_ = false;
  ++cost_.passes;
  dirty_ = sets_.joined();
  for (const ConflictSets::Group& group : dirty_) {
    // Shorter windows part what meets, not what stays together.
    if (!group.lasting) cost_.solved += group.size;
    largest_ = std::max(largest_, group.size);
    sets_.each(group.root, [this](Index i) { tracks_[i].outcome.clear(); });
  }
  return dirty_.empty() ? end_window() : kResolve;
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
  length_.learn(cost_, movers_.size());
  if (now_ == target_) return Phase::kFrameDone;
  return begin_window();
}

// --- looking ----------------------------------------------------------------------------------

template <class P>
void ConflictGroups<P>::rebase(At by) {
  const Time& shift = by;
  for (Track& track : tracks_) {
    if (track.first.flight.start != P::Clock::ever()) track.first.flight.start -= shift;
    for (Segment<P>& segment : track.path) {
      if (segment.flight.start != P::Clock::ever()) segment.flight.start -= shift;
    }
  }
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

template <class P>
double ConflictGroups<P>::given_ahead(At now) const {
  double sum = 0;
  const int shift = motion_->step_shift();
  if (!(motion_->pull() > 0)) return sum;
  const Time next = P::Clock::span(P::Clock::steps(now, shift) + 1, shift);
  for (const Index i : movers_) {
    const Disk& disk = flight(i);
    if (motion_->support(disk) == kStepped) sum += motion_->given_ahead(disk, now, next);
  }
  return sum;
}

template <class P>
void ConflictGroups<P>::wake_around(std::size_t ball, At now) {
  if (!motion_->contacts_last() || !motion_->rules().collisions) return;
  const Disk& gone = flight(ball);
  const Vec<S> here = motion_->wrapped(motion_->place(gone, now));
  for (const Index j : movers_) {
    Disk& disk = tracks_[j].path.back().flight;
    if (j == ball) continue;
    if (motion_->support(disk) != kResting && motion_->support(disk) != kLying) continue;
    const S reach = motion_->species(gone).radius + motion_->species(disk).radius;
    if (!near(motion_->way(here, motion_->place(disk, now)), reach, S(kNear))) continue;
    motion_->set_support(disk, kJoins);
  }
}

}  // namespace carom::event
