#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "contact/joint_impact.hpp"
#include "contact/rest_rules.hpp"
#include "solvers/event/tile.hpp"

namespace carom::event {

/// The balls that touch at one instant, and all their contacts.
template <class P>
struct Tile<P>::Instant {
  std::vector<Index> members;  ///< balls and fixed balls; the first is the one it began with
  std::vector<Vec<S>> places;
  std::vector<Body<S>> bodies;
  std::vector<S> spins;  ///< only where balls rub
  std::vector<Contact<S>> contacts;
  struct Stop {
    std::size_t member;
    Index wall;
  };
  std::vector<Stop> stops;  ///< the contacts with walls

  [[nodiscard]] std::size_t find(Index i) const {
    return static_cast<std::size_t>(std::find(members.begin(), members.end(), i) - members.begin());
  }
};

template <class P>
bool Tile<P>::tied(At now) {
  if (ties_.empty()) return false;
  ties_.erase(ties_.begin(), ties_.lower_bound(now));
  return !ties_.empty() && *ties_.begin() == now;
}

template <class P>
bool Tile<P>::touch(Index i, Index j, At now, const Vec<S>& r) const {
  const Disk& a = disks_[i];
  const Disk& b = disks_[j];
  if (!(squared_gap(r, motion_.kind(a).radius + motion_.kind(b).radius) > 0)) return true;
  const bool from_contact = !left_.empty() && (left_[i] == j || left_[j] == i);
  if constexpr (kCanRest) {
    if (motion_.clusters() &&
        near(r, S(motion_.kind(a).radius + motion_.kind(b).radius), S(kTouching / 32)) &&
        motion_.collapses(a, b, now)) {
      return true;
    }
  }
  return motion_.pair_meets(a, b, from_contact, now) == now;
}

template <class P>
void Tile<P>::add_member(Instant& instant, Index i, At now) const {
  const Disk& disk = disks_[i];
  instant.members.push_back(i);
  instant.places.push_back(motion_.wrapped(motion_.place(disk, now)));
  instant.bodies.push_back({motion_.velocity(disk, now), motion_.kind(disk).inverse_mass});
  if (!spins_.empty()) instant.spins.push_back(spins_[i]);
}

template <class P>
void Tile<P>::add_contacts(Instant& instant, std::size_t member, At now) {
  const Index i = instant.members[member];
  const Disk& disk = disks_[i];
  const auto& rules = motion_.rules();
  if (motion_.fixed(disk)) return;
  for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
    if (!rules.domain.solid((wall - kWalls) / 2)) continue;
    if (motion_.wall(disk, instant.places[member], wall).gap > 0 &&
        motion_.wall_meets(disk, wall) != now) {
      continue;
    }
    const S side = wall % 2 == kWalls % 2 ? -1 : 1;
    const Vec<S> towards = wall - kWalls < 2 ? Vec<S>{side, S(0)} : Vec<S>{S(0), side};
    instant.stops.push_back({member, wall});
    instant.contacts.push_back(
        {static_cast<int>(member), kWall, towards, S(rules.wall_restitution)});
  }
  if (!rules.collisions) return;
  neighbours_.lists().each(i, [&](Index j) {
    const std::size_t other = instant.find(j);
    const bool known = other < instant.members.size();
    const Vec<S> there =
        known ? instant.places[other] : motion_.wrapped(motion_.place(disks_[j], now));
    const Vec<S> r = motion_.way(instant.places[member], there);
    if (!touch(i, j, now, r)) return;
    if (!known) add_member(instant, j, now);
    // Each pair once: with the later of its balls, or the one that is not fixed.
    if (other > member && !motion_.fixed(disks_[j])) return;
    instant.contacts.push_back(
        {static_cast<int>(member), static_cast<int>(other), r, S(rules.restitution)});
  });
}

// Whether one of a crowd touches, two cling to each other, or they are too many.
template <class P>
bool Tile<P>::is_of_crowd(const Instant& instant, At now) const requires kCanRest {
  // Elastic ones part again.
  if (motion_.rules().restitution < 1 && instant.contacts.size() > kManyContacts) return true;
  for (const Index m : instant.members) {
    if (motion_.crowded(disks_[m])) return true;
  }
  return std::any_of(instant.contacts.begin(), instant.contacts.end(),
                     [&](const Contact<S>& contact) {
                       if (contact.b == kWall) return false;
                       const auto a = static_cast<std::size_t>(contact.a);
                       const auto b = static_cast<std::size_t>(contact.b);
                       const Vec<S> v = instant.bodies[b].velocity - instant.bodies[a].velocity;
                       return !(sharp_dot(contact.r, v) > 0) &&
                              motion_.clings(disks_[instant.members[a]], disks_[instant.members[b]],
                                             contact.r, now);
                     });
}

template <class P>
void Tile<P>::meet_jointly(Index i, Index partner, At now) {
  Instant instant;
  add_member(instant, i, now);
  if (partner < kFirstMark) add_member(instant, partner, now);
  for (std::size_t k = 0; k < instant.members.size(); ++k) {
    // A crowd is resolved as a whole.
    if (motion_.hops() && motion_.crowded(disks_[instant.members[k]])) continue;
    add_contacts(instant, k, now);
  }
  if constexpr (kCanRest) {
    if (motion_.hops() && is_of_crowd(instant, now)) {
      Gathering crowd;
      for (const Index m : instant.members) {
        if (!motion_.fixed(disks_[m])) join(crowd, m, now);
      }
      hit_crowd(crowd, now);
      return;
    }
  }

  // Nothing else touches: it is an impact like others, however it came to be looked at.
  if (instant.contacts.size() == 1 &&
      (partner < kFirstMark ? instant.members.size() == 2 && instant.stops.empty()
                            : !instant.stops.empty() && instant.stops.front().wall == partner)) {
    const bool ball = partner < kFirstMark && !motion_.fixed(disks_[partner]);
    const Before was = before(i);
    const Before partner_was = ball ? before(partner) : Before{};
    meet_alone(i, partner, now);
    book_.keep();
    if (log_ != nullptr) log_alone(i, partner, was, partner_was, now);
    if (ball) look_again(partner, now);
    look_again(i, now);
    return;
  }

  const std::vector<Body<S>> before = instant.bodies;
  ++counts_.joint_impacts;
  JointLog joint;
  const JointReport report = resolve(instant, log_ != nullptr ? &joint : nullptr);
  if (log_ != nullptr) log_joint(instant, joint, now);
  const auto walls = static_cast<std::uint64_t>(report.walls);
  const auto balls = static_cast<std::uint64_t>(report.impacts);
  counts_.ball_wall += walls;
  counts_.ball_ball += balls;
  book_.note(report.lost);
  book_.keep();

  std::vector<Index> changed;
  for (std::size_t k = 0; k < instant.members.size(); ++k) {
    const Index m = instant.members[k];
    Disk& disk = disks_[m];
    if (motion_.fixed(disk)) continue;
    bool same = before[k].velocity == instant.bodies[k].velocity;
    if (!spins_.empty()) same = same && spins_[m] == instant.spins[k];
    if (same && m != i && m != partner) continue;
    unlink(m);
    forget(m);
    changed.push_back(m);
    if (same) continue;
    disk.x = instant.places[k].x;
    disk.y = instant.places[k].y;
    disk.vx = instant.bodies[k].velocity.x;
    disk.vy = instant.bodies[k].velocity.y;
    if (!spins_.empty()) spins_[m] = instant.spins[k];
    disk.start = now;
    if (!left_.empty()) left_[m] = kUnknown;
  }
  for (const typename Instant::Stop& stop : instant.stops) {
    Disk& disk = disks_[instant.members[stop.member]];
    if (disk.start != now) continue;
    const S at = motion_.wall(disk, {disk.x, disk.y}, stop.wall).stop;
    (stop.wall - kWalls < 2 ? disk.x : disk.y) = at;
  }
  if (!left_.empty()) {
    for (const Contact<S>& contact : instant.contacts) {
      if (contact.b == kWall) continue;
      const Index a = instant.members[static_cast<std::size_t>(contact.a)];
      const Index b = instant.members[static_cast<std::size_t>(contact.b)];
      if (motion_.fixed(disks_[b]) && disks_[a].start == now) left_[a] = b;
    }
  }
  if constexpr (kCanRest) {
    for (const Index m : changed) lean(m);
    book_.keep();
    if (motion_.clusters()) {
      for (const Contact<S>& contact : instant.contacts) {
        if (contact.b == kWall || contact.restitution == 1) continue;
        const Disk& a = disks_[instant.members[static_cast<std::size_t>(contact.a)]];
        const Disk& b = disks_[instant.members[static_cast<std::size_t>(contact.b)]];
        if (a.start == now && b.start == now && motion_.stay_together(a, b)) {
          ++counts_.resting_contacts;
        }
      }
    }
  }
  for (const Index m : changed) look_again(m, now);
}

}  // namespace carom::event
