#pragma once

#include <algorithm>

#include "contact/rest_rules.hpp"
#include "solvers/event/groups/conflict_groups.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

template <class P>
void ConflictGroups<P>::look_at_pairs(Share share) {
  Desk& desk = desks_[share.index];
  const Stopwatch stopwatch(true, desk.pair_seconds);
  desk.encounters.clear();
  desk.touching.clear();
  const std::vector<RegionPair>& pairs = region_pairs_.pairs();
  const std::array<double, 2>& periods = motion_->rules().domain.period;
  const std::size_t end = share.end(pairs.size());
  for (std::size_t k = share.begin(pairs.size()); k < end; ++k) {
    const auto [i, j] = pairs[k];
    const Track& a = tracks_[i];
    const Track& b = tracks_[j];
    if (!first_pass_ && !a.changed && !b.changed) continue;
    if (!a.box.near(b.box, (radii_[i] + radii_[j]) * kWidest, periods)) continue;
    if (first_pass_ && touch(i, j, a.first.flight, b.first.flight, now_)) {
      desk.touching.push_back({i, j});
    }
    if (same_group(i, j)) continue;
    const bool lasting = lasts(i, j);
    if (lasting || meet(i, j)) desk.encounters.push_back({i, j, lasting});
  }
}

template <class P>
bool ConflictGroups<P>::same_group(Index i, Index j) const {
  const Index group = groups_.look_up(i);
  if (fixed_[j] == 0) return group == groups_.look_up(j);
  const std::vector<Index>& fixed_disks = fixed_disks_[group];
  return std::find(fixed_disks.begin(), fixed_disks.end(), j) != fixed_disks.end();
}

// Balls of an island that moves, or is hit, are looked at with all that are near to them.
template <class P>
bool ConflictGroups<P>::lasts(Index i, Index j) const {
  if (!motion_->hops()) return false;
  const auto in_island = [this](Index k) {
    const Path& path = tracks_[k].path;
    return fixed_[k] == 0 && std::any_of(path.begin(), path.end(), [this](const auto& segment) {
             return motion_->in_island(segment.flight);
           });
  };
  const auto moves = [this](Index k) {
    const Path& path = tracks_[k].path;
    return fixed_[k] == 0 &&
           (path.size() > 1 || motion_->carried(tracks_[k].first.flight) >= kStepped);
  };
  return (in_island(i) || in_island(j)) && (moves(i) || moves(j));
}

// Whether a third ball that meets one of the two then has to do with the other.
template <class P>
bool ConflictGroups<P>::touch(Index i, Index j, const Disk& a, const Disk& b, At at) const {
  const S reach = motion_->species(a).radius + motion_->species(b).radius;
  double part = kTouching;
  if (motion_->hops()) {
    const auto in_island = [this](Index k, const Disk& disk) {
      return fixed_[k] == 0 && motion_->in_island(disk);
    };
    if (in_island(i, a) || in_island(j, b)) part = kNear;
  }
  return near(motion_->way(motion_->place(a, at), motion_->place(b, at)), reach, S(part));
}

// Whether the two paths meet, or touch where one of them has an impact.
template <class P>
bool ConflictGroups<P>::meet(Index i, Index j) const {
  const Path& first = tracks_[i].path;
  const Path& second = tracks_[j].path;
  const auto end_of = [this](const Path& path, std::size_t k) -> const Time& {
    return k + 1 < path.size() ? path[k + 1].flight.start : until_;
  };
  std::size_t a = 0;
  std::size_t b = 0;
  for (;;) {
    const Segment<P>& one = first[a];
    const Segment<P>& other = second[b];
    const Time& one_ends = end_of(first, a);
    const Time& other_ends = end_of(second, b);
    const Time& end = std::min(one_ends, other_ends);
    const bool from_contact = fixed_[j] != 0 && one.left == j;
    if (motion_->pair_meets(one.flight, other.flight, from_contact, end) <= end) return true;
    const bool more = a + 1 < first.size() || b + 1 < second.size();
    if (!more) return false;
    if (touch(i, j, one.flight, other.flight, end)) return true;
    // Both where they end at once, so that what begins then is held against what begins then.
    const bool next_a = a + 1 < first.size() && !(end < one_ends);
    const bool next_b = b + 1 < second.size() && !(end < other_ends);
    if (next_a) ++a;
    if (next_b) ++b;
    if (!next_a && !next_b) return false;
  }
}

}  // namespace carom::event
