#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/event/groups/conflict_groups.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

// A region is wider than a path by so much of the gap between neighbours, and of a diameter.
inline constexpr double kMarginOfGap = 0.35;
inline constexpr double kMarginOfDiameter = 0.25;
// Windows get shorter where more than so many passes were taken, or balls solved for each ball.
inline constexpr std::size_t kManyPasses = 4;
inline constexpr double kManySolved = 0.6;
inline constexpr double kShorterWindow = 0.7;
inline constexpr double kLongerWindow = 1.15;
// The first window, as a part of the time in which a ball meets another; no window is so many times
// longer or shorter than that.
inline constexpr double kFirstPart = 0.2;
inline constexpr double kMostTimes = 32;

template <class P>
ConflictGroups<P>::ConflictGroups(const BasicRules<S>& rules)
    : motion_(std::make_shared<const Motion<P>>(rules)), desks_(1), region_pairs_(rules.domain) {}

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
  fixed_disks_.assign(n, {});
  is_dirty_.assign(n, 0);
  lasts_.assign(n, 0);
  noted_.clear();
  lost_.clear();
  double supported_loss = 0;
  movers_.clear();
  listed_ = false;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    turns_[axis].clear();
    if (motion_->rules().falls_round(axis)) turns_[axis].resize(n, 0);
  }
  for (std::size_t i = 0; i < n; ++i) {
    Disk flight = flights[i];
    S spin = spins.empty() ? S(0) : spins[i];
    radii_[i] = static_cast<double>(motion_->species(flight).radius);
    if (motion_->fixed(flight)) {
      fixed_[i] = 1;
      flight.start = P::Clock::ever();
    } else {
      movers_.push_back(static_cast<Index>(i));
      const unsigned carried = motion_->carried(flight);
      if (motion_->hops() && carried != kLying && carried < kResting && flight.start == now_) {
        supported_loss += std::max(
            motion_->support_on_walls(flight, motion_->rules().spins ? &spin : nullptr), 0.0);
      }
    }
    tracks_[i].first = {flight, left.empty() ? kUnknown : left[i], spin};
    tracks_[i].path.push_back(tracks_[i].first);
    set_box(static_cast<Index>(i));
  }
  if (supported_loss != 0) lost_.add(supported_loss);
  measure_window();
  window_ = usual_;
}

template <class P>
void ConflictGroups<P>::measure_window() {
  double square = 0;
  double diameter = 0;
  for (const Index i : movers_) {
    const Disk& disk = flight(i);
    const auto x = static_cast<double>(disk.vx);
    const auto y = static_cast<double>(disk.vy);
    square += x * x + y * y;
    diameter += 2 * radii_[i];
  }
  const auto n = static_cast<double>(std::max<std::size_t>(movers_.size(), 1));
  diameter /= n;
  const auto& rules = motion_->rules();
  const double area = (rules.domain.upper[0] - rules.domain.lower[0]) *
                      (rules.domain.upper[1] - rules.domain.lower[1]);
  const double pitch = std::sqrt(area / n);
  const double gap = std::max(pitch - diameter, pitch / 16);
  margin_ = kMarginOfDiameter * diameter + kMarginOfGap * gap;
  for (const double period : rules.domain.period) {
    if (period > 0) margin_ = std::min(margin_, period / 8);
  }
  const double gravity = std::hypot(rules.gravity[0], rules.gravity[1]);
  const double speed = std::sqrt(square / n + gravity * pitch);
  const double across = diameter > 0 ? gap * pitch / diameter : gap;
  const Time most = Time(P::Clock::longest_flight() / 64);
  usual_ = speed > 0 ? rules.scale.ticks(S(kFirstPart * across / speed)) : most;
  usual_ = std::min(std::max(usual_, Time(64)), most);
}

template <class P>
std::size_t ConflictGroups<P>::aim(At until) {
  target_ = until;
  if (!(now_ < target_)) return Phase::kFrameDone;
  return begin_window();
}

template <class P>
std::size_t ConflictGroups<P>::begin_window() {
  const Time wanted = std::min(window_, longest_);
  full_ = wanted <= target_ - now_;
  until_ = full_ ? Time(now_ + wanted) : target_;
  solved_ = 0;
  rounds_ = 0;
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
      look_at_pairs(share);
      break;
    default: {
      Desk& desk = desks_[share.index];
      desk.outside = false;
      for (std::size_t k = share.index; k < dirty_.size(); k += share.count) {
        const Index root = dirty_[k].root;
        desk.members = fixed_disks_[root];
        groups_.each(root, [&](Index i) { desk.members.push_back(i); });
        solve(root, desk);
      }
    }
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

// Each ball as if it were alone: most meet nothing, and their flights just go on.
template <class P>
void ConflictGroups<P>::fly(Share share) {
  Desk& desk = desks_[share.index];
  const Stopwatch stopwatch(true, desk.wall_seconds);
  desk.outside = false;
  const std::size_t end = share.end(movers_.size());
  for (std::size_t k = share.begin(movers_.size()); k < end; ++k) {
    const Index i = movers_[k];
    Track& track = tracks_[i];
    begin(track);
    if (flies_on(track.first)) {
      set_box(i);
    } else {
      desk.members.assign(1, i);
      solve(i, desk);
    }
    desk.outside = desk.outside || !regions_[i].contains(track.box, motion_->rules().domain.period);
  }
}

// The window begins with the flight that the one before has ended with.
template <class P>
void ConflictGroups<P>::begin(Track& track) {
  track.first = track.path.back();
  track.path.assign(1, track.first);
}

template <class P>
bool ConflictGroups<P>::flies_on(const Segment<P>& segment) const {
  if (motion_->carried(segment.flight) >= kStepped) return false;
  const S* spin = motion_->rules().spins ? &segment.spin : nullptr;
  return motion_->alone(segment.flight, until_, spin).time > until_;
}

// One event loop over a group's balls, from the flights that they begin the window with.  The balls
// keep their order.
template <class P>
void ConflictGroups<P>::solve(Index root, Desk& desk) {
  if (!desk.loop) desk.loop = std::make_unique<EventLoop<P>>(motion_, tracks_.size());
  std::vector<Index>& members = desk.members;
  const std::size_t moving = members.size();
  for (std::size_t k = 0; k < moving; ++k) {
    const Index fixed_disk = tracks_[members[k]].first.left;
    if (fixed_disk != kUnknown) members.push_back(fixed_disk);
  }
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
  const auto slot_of = [&](Index ball) {
    if (ball == kUnknown) return kUnknown;
    const auto at = std::lower_bound(members.begin(), members.end(), ball);
    return static_cast<Index>(at - members.begin());
  };
  desk.flights.clear();
  desk.lefts.clear();
  desk.first.clear();
  desk.spins.clear();
  for (const Index i : members) {
    const Segment<P>& first = tracks_[i].first;
    desk.flights.push_back(first.flight);
    desk.lefts.push_back(slot_of(first.left));
    desk.spins.push_back(first.spin);
    desk.first.push_back({first.flight, desk.lefts.back(), first.spin});
  }
  EventLoop<P>& loop = *desk.loop;
  desk.paths.reset(desk.first);
  loop.record(&desk.paths);
  loop.reset(desk.flights, now_, desk.lefts, desk.spins);
  (void)loop.take_counts();
  (void)loop.take_lost();
  desk.log.impacts.clear();
  loop.note_in(notes_ ? &desk.log : nullptr);
  loop.advance_to(until_);
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Index i = members[k];
    if (fixed_[i] != 0) continue;
    Track& track = tracks_[i];
    track.path.assign(desk.paths[k].begin(), desk.paths[k].end());
    track.path.back().left = loop.left(static_cast<Index>(k));
    for (Segment<P>& segment : track.path) {
      if (segment.left != kUnknown) segment.left = members[segment.left];
    }
    track.changed = true;
    track.counts = {};
    track.lost.clear();
    track.impacts.clear();
    desk.solved.push_back(i);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!loop.turns()[axis].empty()) track.turns[axis] = loop.turns()[axis][k];
    }
    set_box(i);
    if (!regions_[i].contains(track.box, motion_->rules().domain.period)) desk.outside = true;
  }
  tracks_[root].counts = loop.take_counts();
  tracks_[root].lost = loop.take_lost();
  for (Impact& impact : desk.log.impacts) {
    impact.a = members[impact.a];
    if (impact.b != Impact::kNoBall) impact.b = members[impact.b];
  }
  tracks_[root].impacts = desk.log.impacts;
}

// What the centre sweeps: from each flight's start to its end, and as far beside the chord as the
// flight can bend.
template <class P>
void ConflictGroups<P>::set_box(Index ball) {
  Track& track = tracks_[ball];
  const Path& path = track.path;
  if (fixed_[ball] != 0) {
    const Disk& disk = path.front().flight;
    track.box = {{static_cast<double>(disk.x), static_cast<double>(disk.y)}, {0, 0}};
    return;
  }
  const Domain& domain = motion_->rules().domain;
  std::array<double, 2> low{};
  std::array<double, 2> high{};
  std::array<double, 2> shift{0, 0};  // of the image that a flight is in
  std::array<double, 2> last{};
  for (std::size_t k = 0; k < path.size(); ++k) {
    const Disk& disk = path[k].flight;
    const Time from = k == 0 ? now_ : disk.start;
    const Time to = k + 1 < path.size() ? path[k + 1].flight.start : until_;
    const Flight<S> begins = motion_->at(disk, from);
    const Vec<S> ends = motion_->place(disk, to);
    const auto span = static_cast<double>(motion_->rules().scale.seconds(to - from));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const S& v = axis == 0 ? begins.velocity.x : begins.velocity.y;
      auto at = static_cast<double>(axis == 0 ? begins.position.x : begins.position.y);
      const auto end = static_cast<double>(axis == 0 ? ends.x : ends.y);
      const double way = end - at;
      if (k > 0 && domain.period[axis] > 0) {
        shift[axis] = domain.period[axis] * std::rint((last[axis] - at) / domain.period[axis]);
      }
      at += shift[axis];
      last[axis] = at + way;
      const double bend =
          std::abs(static_cast<double>(S(motion_->law_of(disk).push(axis, v)))) * span * span / 8;
      const double lowest = std::min(at, last[axis]) - bend;
      const double highest = std::max(at, last[axis]) + bend;
      low[axis] = k == 0 ? lowest : std::min(low[axis], lowest);
      high[axis] = k == 0 ? highest : std::max(high[axis], highest);
    }
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double length = domain.upper[axis] - domain.lower[axis];
    track.box.centre[axis] = low[axis] + (high[axis] - low[axis]) / 2;
    track.box.half[axis] = (high[axis] - low[axis]) / 2 * (1 + 0x1p-20) +
                           (length + std::abs(low[axis]) + std::abs(high[axis])) * 0x1p-44;
  }
}

template <class P>
bool ConflictGroups<P>::any_outside() {
  return std::any_of(desks_.begin(), desks_.end(), [](const Desk& desk) { return desk.outside; });
}

template <class P>
void ConflictGroups<P>::list_pairs() {
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    regions_[i] = tracks_[i].box;
    if (fixed_[i] != 0) continue;
    for (double& half : regions_[i].half) half += margin_;
  }
  measure_window();
  region_pairs_.build(regions_, radii_, fixed_, kWidest);
  listed_ = true;
}

template <class P>
std::size_t ConflictGroups<P>::after_flight() {
  if (!motion_->rules().collisions) return end_window();
  groups_.reset(tracks_.size());
  clusters_.reset(tracks_.size());
  if (!listed_ || any_outside()) list_pairs();
  return kPairs;
}

template <class P>
bool ConflictGroups<P>::before(const Encounter& one, const Encounter& other) {
  return one.first != other.first ? one.first < other.first : one.second < other.second;
}

// Groups that meet become one; what has changed since the last pass has been looked at.
template <class P>
std::size_t ConflictGroups<P>::merge() {
  if (first_pass_) {
    supports_.clear();
    for (const Desk& desk : desks_) {
      for (const Encounter& pair : desk.touching) {
        if (fixed_[pair.second] != 0) {
          supports_.push_back(pair);
        } else {
          clusters_.merge(pair.first, pair.second);
        }
      }
    }
    std::sort(supports_.begin(), supports_.end(), before);
  }
  for (const Desk& desk : desks_) {
    for (const Index i : desk.solved) tracks_[i].changed = false;
  }
  std::vector<Index> hit;
  for (const Desk& desk : desks_) {
    for (const Encounter& pair : desk.encounters) {
      hit.push_back(pair.first);
      if (pair.lasts) lasts_[pair.first] = 1;
      if (fixed_[pair.second] != 0) {
        fixed_disks_[groups_.find(pair.first)].push_back(pair.second);
        continue;
      }
      join(pair.first, pair.second);
    }
  }
  first_pass_ = false;
  ++rounds_;
  for (const Index i : hit) close(i);
  dirty_.clear();
  for (const Index i : hit) {
    const Index root = groups_.find(i);
    if (is_dirty_[root] != 0) continue;
    is_dirty_[root] = 1;
    std::vector<Index>& fixed_disks = fixed_disks_[root];
    std::sort(fixed_disks.begin(), fixed_disks.end());
    fixed_disks.erase(std::unique(fixed_disks.begin(), fixed_disks.end()), fixed_disks.end());
    std::size_t size = 0;
    bool lasting = false;
    groups_.each(root, [&](Index k) {
      ++size;
      lasting = lasting || lasts_[k] != 0;
    });
    dirty_.push_back({root, size});
    // Shorter windows part what meets, not what stays together.
    if (!lasting) solved_ += size;
  }
  for (const Group& group : dirty_) {
    is_dirty_[group.root] = 0;
    groups_.each(group.root, [this](Index i) {
      tracks_[i].counts = {};
      tracks_[i].impacts.clear();
      tracks_[i].lost.clear();
    });
    largest_ = std::max(largest_, group.size);
  }
  if (dirty_.empty()) return end_window();
  // The largest first, so that the workers end together.
  std::sort(dirty_.begin(), dirty_.end(), [](const Group& a, const Group& b) {
    return a.size != b.size ? a.size > b.size : a.root < b.root;
  });
  return kResolve;
}

template <class P>
void ConflictGroups<P>::join(Index i, Index j) {
  const Index one = groups_.find(i);
  const Index other = groups_.find(j);
  if (!groups_.merge(one, other)) return;
  const Index root = groups_.find(one);
  std::vector<Index>& from = fixed_disks_[root == one ? other : one];
  fixed_disks_[root].insert(fixed_disks_[root].end(), from.begin(), from.end());
  from.clear();
}

// A group has all balls of the clusters that its members are of, and what these touch.
template <class P>
void ConflictGroups<P>::close(Index ball) {
  groups_.each(ball, [this](Index i) {
    const auto first =
        std::lower_bound(supports_.begin(), supports_.end(), Encounter{i, 0}, before);
    for (auto at = first; at != supports_.end() && at->first == i; ++at) {
      fixed_disks_[groups_.find(i)].push_back(at->second);
    }
    if (clusters_.alone(i)) return;
    clusters_.each(i, [&](Index k) { join(i, k); });
  });
}

template <class P>
std::size_t ConflictGroups<P>::end_window() {
  for (Desk& desk : desks_) {
    for (const Index i : desk.solved) {
      Track& track = tracks_[i];
      counts_ += track.counts;
      for (const double part : track.lost) lost_.add(part);
      track.lost.clear();
      lasts_[i] = 0;
      const std::uint64_t joint = noted_.size();
      for (Impact& impact : track.impacts) {
        if (impact.event != 0) impact.event += joint;
        noted_.push_back(impact);
      }
      track.impacts.clear();
      for (std::size_t axis = 0; axis < 2; ++axis) {
        if (!turns_[axis].empty()) turns_[axis][i] += track.turns[axis];
      }
      // A ball may have been solved more than once.
      track.counts = {};
      track.turns = {0, 0};
      track.changed = false;
      fixed_disks_[i].clear();
    }
    desk.solved.clear();
  }
  now_ = until_;
  ++windows_;
  passes_ += rounds_;
  const bool dear =
      rounds_ > kManyPasses ||
      static_cast<double>(solved_) > kManySolved * static_cast<double>(movers_.size()) + 8;
  if (dear || full_) {
    const S wanted = static_cast<S>(window_) * (dear ? kShorterWindow : kLongerWindow);
    const S usual = static_cast<S>(usual_);
    window_ =
        P::Clock::whole(std::min(std::max(wanted, S(usual / kMostTimes)), S(usual * kMostTimes)));
  }
  if (now_ == target_) return Phase::kFrameDone;
  return begin_window();
}

template <class P>
void ConflictGroups<P>::take_impacts(std::vector<Impact>& impacts) {
  impacts.insert(impacts.end(), noted_.begin(), noted_.end());
  noted_.clear();
}

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
  for (const Desk& desk : desks_) {
    if (desk.loop) costs += desk.loop->costs();
    costs.collisions += desk.pair_seconds;
    costs.walls += desk.wall_seconds;
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
    if (motion_->carried(disk) == kStepped) sum += motion_->given_ahead(disk, now, next);
  }
  return sum;
}

template <class P>
void ConflictGroups<P>::wake_around(std::size_t ball, At now) {
  if (!motion_->hops() || !motion_->rules().collisions) return;
  const Disk& gone = flight(ball);
  const Vec<S> here = motion_->wrapped(motion_->place(gone, now));
  for (const Index j : movers_) {
    Disk& disk = tracks_[j].path.back().flight;
    if (j == ball) continue;
    if (motion_->carried(disk) != kResting && motion_->carried(disk) != kLying) continue;
    const S reach = motion_->species(gone).radius + motion_->species(disk).radius;
    if (!near(motion_->way(here, motion_->place(disk, now)), reach, S(kNear))) continue;
    motion_->set_carried(disk, kJoins);
  }
}

}  // namespace carom::event
