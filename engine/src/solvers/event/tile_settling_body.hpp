#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "contact/event_exact_sum.hpp"
#include "contact/event_rest.hpp"
#include "contact/event_settling.hpp"
#include "solvers/event/tile.hpp"

namespace carom::event {

/// All balls as they are at one instant, in cells.
template <class P>
struct Tile<P>::Crowd {
  std::vector<Vec<S>> place;
  std::vector<Vec<S>> velocity;
  std::array<std::size_t, 2> cells{1, 1};
  std::vector<std::size_t> cell;    ///< by ball
  std::vector<std::size_t> starts;  ///< by cell, into `balls`
  std::vector<Index> balls;

  Crowd(const Tile& tile, At now) {
    const Motion<P>& motion = tile.motion_;
    const Domain& domain = motion.rules().domain;
    const std::size_t n = tile.disks_.size();
    const double range = 2 * motion.largest_radius() * (1 + 2 * kNear);
    std::array<double, 2> per_length{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double length = domain.upper[axis] - domain.lower[axis];
      const double most = 2 * std::sqrt(static_cast<double>(n)) + 1;
      cells[axis] = static_cast<std::size_t>(std::clamp(length / range, 1.0, most));
      per_length[axis] = static_cast<double>(cells[axis]) / length;
    }
    starts.assign(cells[0] * cells[1] + 1, 0);
    for (const Disk& disk : tile.disks_) {
      place.push_back(motion.wrapped(motion.place(disk, now)));
      velocity.push_back(motion.velocity(disk, now));
      const auto along = [&](const S& x, std::size_t axis) {
        const double at = (static_cast<double>(x) - domain.lower[axis]) * per_length[axis];
        return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(cells[axis] - 1)));
      };
      cell.push_back(along(place.back().y, 1) * cells[0] + along(place.back().x, 0));
      ++starts[cell.back() + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    balls.resize(n);
    std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
    for (std::size_t i = 0; i < n; ++i) balls[next[cell[i]]++] = static_cast<Index>(i);
  }

  /// Every ball in the cell of ball i and around it.
  template <class Visit>
  void each_around(const Domain& domain, Index i, const Visit& visit) const {
    const std::size_t column = cell[i] % cells[0];
    const std::size_t row = cell[i] / cells[0];
    const auto span = [&](std::size_t axis, std::size_t at) {
      std::vector<std::size_t> result;
      const std::size_t count = cells[axis];
      const bool wraps = domain.period[axis] > 0 && count > 2;
      for (std::size_t k = 0; k < 3; ++k) {
        if (at + k >= 1 && at + k <= count) {
          result.push_back(at + k - 1);
        } else if (wraps) {
          result.push_back((at + k + count - 1) % count);
        }
      }
      return result;
    };
    for (const std::size_t r : span(1, row)) {
      for (const std::size_t c : span(0, column)) {
        const std::size_t here = r * cells[0] + c;
        for (std::size_t k = starts[here]; k < starts[here + 1]; ++k) visit(balls[k]);
      }
    }
  }
};

/// Balls near each other that move slowly to each other, what is fixed near them, and all near
/// contacts.
template <class P>
struct Tile<P>::Group {
  std::size_t moving = 0;      ///< the first so many members
  std::vector<Index> members;  ///< then the fixed balls
  std::vector<Body<S>> bodies;
  std::vector<NearContact<S>> near_contacts;
  std::vector<Index> walls;  ///< by contact: the wall, or kUnknown
  Vec<S> drift{S(0), S(0)};  ///< their common velocity where nothing stops them
  S smallest = 0;            ///< radius
};

template <class P>
void Tile<P>::settle_groups(At now) requires(P::kRests) {
  if (!motion_.rules().collisions || !(motion_.rules().restitution < 1)) return;
  // Nothing new where nothing has happened: this is asked of the flights, so that a run that was
  // stopped and goes on asks the same.
  const Time since = now - P::Clock::span(1, settling_shift_);
  const bool quiet = std::none_of(disks_.begin(), disks_.end(), [&](const Disk& disk) {
    return !motion_.fixed(disk) && !motion_.asleep(disk) && disk.start > since;
  });
  if (quiet) return;
  const Crowd crowd(*this, now);
  std::vector<char> seen(disks_.size(), 0);
  std::vector<std::vector<Index>> groups;
  for (Index i = 0; i < disks_.size(); ++i) {
    if (seen[i] || motion_.fixed(disks_[i]) || motion_.asleep(disks_[i])) continue;
    std::vector<Index> members;
    if (gather_group(crowd, i, seen, members)) groups.push_back(std::move(members));
  }
  for (const std::vector<Index>& members : groups) settle_group(crowd, members, now);
}

// Whoever can be reached over near contacts whose balls move slowly to each other; false: nobody
// is near, or something fast is.
template <class P>
bool Tile<P>::gather_group(const Crowd& crowd, Index first, std::vector<char>& seen,
                           std::vector<Index>& members) const requires(P::kRests) {
  bool touches = false;
  bool disturbed = false;
  members.assign(1, first);
  seen[first] = 1;
  for (std::size_t m = 0; m < members.size(); ++m) {
    const Index k = members[m];
    crowd.each_around(motion_.rules().domain, k, [&](Index j) {
      if (j == k) return;
      const S reach = motion_.kind(disks_[k]).radius + motion_.kind(disks_[j]).radius;
      if (!near(motion_.way(crowd.place[k], crowd.place[j]), reach, S(kNear))) return;
      touches = true;
      if (motion_.fixed(disks_[j])) return;
      const Vec<S> v = crowd.velocity[j] - crowd.velocity[k];
      if (!slow(v, motion_.hop_speed(reach))) {
        disturbed = true;
      } else if (seen[j] == 0) {
        seen[j] = 1;
        members.push_back(j);
      }
    });
  }
  return touches && !disturbed;
}

template <class P>
auto Tile<P>::describe(const Crowd& crowd, const std::vector<Index>& members) const -> Group
    requires(P::kRests) {
  const Domain& domain = motion_.rules().domain;
  Group group;
  group.moving = members.size();
  group.members = members;
  std::vector<int> number(disks_.size(), -1);
  std::array<bool, 2> stopped{false, false};
  group.smallest = motion_.kind(disks_[members.front()]).radius;
  ExactSum<S> mass;
  ExactSum<S> x;
  ExactSum<S> y;
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Index i = members[k];
    const auto& kind = motion_.kind(disks_[i]);
    number[i] = static_cast<int>(k);
    group.bodies.push_back({crowd.velocity[i], kind.inverse_mass});
    group.smallest = std::min(group.smallest, kind.radius);
    mass.add(1 / kind.inverse_mass);
    x.add(crowd.velocity[i].x / kind.inverse_mass);
    y.add(crowd.velocity[i].y / kind.inverse_mass);
    for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
      const std::size_t axis = (wall - kWalls) / 2;
      if (!domain.solid(axis)) continue;
      const S gap = motion_.wall(disks_[i], crowd.place[i], wall).gap;
      if (gap > 2 * kind.radius * kNear) continue;
      const S side = wall % 2 == kWalls % 2 ? -1 : 1;
      const Vec<S> towards = axis == 0 ? Vec<S>{side, S(0)} : Vec<S>{S(0), side};
      group.near_contacts.push_back({static_cast<int>(k), kWall, towards, gap});
      group.walls.push_back(wall);
      stopped[axis] = true;
    }
  }
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Index i = members[k];
    crowd.each_around(domain, i, [&](Index j) {
      const bool fixed = motion_.fixed(disks_[j]);
      if (j == i || (!fixed && number[j] < static_cast<int>(k))) return;
      const Vec<S> r = motion_.way(crowd.place[i], crowd.place[j]);
      const S reach = motion_.kind(disks_[i]).radius + motion_.kind(disks_[j]).radius;
      if (!near(r, reach, S(kNear))) return;
      if (number[j] < 0) {
        number[j] = static_cast<int>(group.members.size());
        group.members.push_back(j);
        group.bodies.push_back({{S(0), S(0)}, S(0)});
      }
      if (fixed) stopped = {true, true};
      group.near_contacts.push_back({static_cast<int>(k), number[j], r, reach});
      group.walls.push_back(kUnknown);
    });
  }
  if (!stopped[0]) group.drift.x = x.rounded() / mass.rounded();
  if (!stopped[1]) group.drift.y = y.rounded() / mass.rounded();
  return group;
}

template <class P>
void Tile<P>::settle_group(const Crowd& crowd, const std::vector<Index>& members,
                           At now) requires(P::kRests) {
  Group group = describe(crowd, members);
  const S hop = motion_.hop_speed(2 * group.smallest);
  for (std::size_t k = 0; k < group.moving; ++k) {
    if (!slow(group.bodies[k].velocity - group.drift, hop)) return;
  }
  ++counts_.settlings;
  const Vec<S>& g = motion_.law().pull();
  const S most = 2 * group.smallest * kNear / 2;
  const Vec<S> sink = most / 4 / root(S(g.x * g.x + g.y * g.y)) * g;
  const Settled<S> settled = settle<S>(group.bodies, group.near_contacts, sink, most);
  const std::vector<char> rests =
      resting_bodies<S>(group.bodies, group.near_contacts, settled, most, g);

  std::vector<Index> resting;
  for (std::size_t k = 0; k < group.moving; ++k) {
    if (!rests[k]) continue;
    const Index i = group.members[k];
    Disk& disk = disks_[i];
    unlink(i);
    forget(i);
    const Vec<S> at = motion_.wrapped(crowd.place[i] + settled.shift[k]);
    disk.x = at.x;
    disk.y = at.y;
    disk.vx = group.drift.x;
    disk.vy = group.drift.y;
    disk.start = now;
    motion_.set_carried(disk, kAsleep);
    left_[i] = kUnknown;
    resting.push_back(i);
  }
  for (std::size_t k = 0; k < group.near_contacts.size(); ++k) {
    const auto a = static_cast<std::size_t>(group.near_contacts[k].a);
    if (!rests[a] || !(settled.loads[k] > 0)) continue;
    ++counts_.resting_contacts;
    if (group.walls[k] == kUnknown) continue;
    // Walls are where they are.
    Disk& disk = disks_[group.members[a]];
    const S stop = motion_.wall(disk, {disk.x, disk.y}, group.walls[k]).stop;
    (group.walls[k] - kWalls < 2 ? disk.x : disk.y) = stop;
  }
  for (const Index i : resting) (void)neighbours_.renew(disks_, i, now);
  for (const Index i : resting) look_again(i, now);
}

}  // namespace carom::event
