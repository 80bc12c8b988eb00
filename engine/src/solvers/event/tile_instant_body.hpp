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
    bool meets;  ///< it is at the wall: not only so near that it is taken as jammed
  };
  std::vector<Stop> stops;  ///< the contacts with walls

  [[nodiscard]] std::size_t find(Index i) const {
    return static_cast<std::size_t>(std::find(members.begin(), members.end(), i) - members.begin());
  }
};

template <class P>
bool Tile<P>::tied(Index i, Index partner, At now) {
  if (ties_.empty()) return false;
  ties_.erase(ties_.begin(), ties_.lower_bound({now, 0}));
  if (ties_.count({now, i}) == 0 && ties_.count({now, partner}) == 0) return false;
  // A tie may be of what was known of a ball before: whether it was noted depends on what was
  // looked at when.
  const bool ball = partner < kFirstMark && !motion_.fixed(disks_[partner]);
  return meets_another(i, partner, now) || (ball && meets_another(partner, i, now));
}

// Whether the ball meets something else at this instant, too.
template <class P>
bool Tile<P>::meets_another(Index i, Index partner, At now) const {
  const Disk& disk = disks_[i];
  for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
    if (wall == partner || !motion_.rules().domain.solid((wall - kWalls) / 2)) continue;
    if (motion_.wall_meets(disk, wall) <= now) return true;
  }
  if (!motion_.rules().collisions) return false;
  bool meets = false;
  neighbours_.lists().each(i, [&](Index j) {
    if (meets || j == partner) return;
    const bool from_contact = !left_.empty() && (left_[i] == j || left_[j] == i);
    meets = motion_.pair_meets(disk, disks_[j], from_contact, now) <= now;
  });
  return meets;
}

template <class P>
bool Tile<P>::touch(Index i, Index j, At now, const Vec<S>& r) const {
  const Disk& a = disks_[i];
  const Disk& b = disks_[j];
  const S reach = motion_.kind(a).radius + motion_.kind(b).radius;
  if (!(squared_gap(r, reach) > 0) || (jams_ > 0 && near(r, reach, S(jam_gap())))) return true;
  const bool from_contact = !left_.empty() && (left_[i] == j || left_[j] == i);
  if (motion_.clusters() &&
      near(r, S(motion_.kind(a).radius + motion_.kind(b).radius), S(kTouching / 32)) &&
      motion_.collapses(a, b, now)) {
    return true;
  }
  return motion_.pair_meets(a, b, from_contact, now) == now;
}

template <class P>
void Tile<P>::add_member(Instant& instant, Index i, At now) const {
  const Disk& disk = disks_[i];
  instant.members.push_back(i);
  instant.places.push_back(motion_.wrapped(motion_.place(disk, now)));
  instant.bodies.push_back({motion_.velocity(disk, now), motion_.kind(disk).inverse_mass});
  if (!spins_.empty()) instant.spins.push_back(motion_.spin_at(disk, spins_[i], now));
}

template <class P>
void Tile<P>::begin_instant() {
  for (const Past& past : past_) is_past_[past.ball] = 0;
  past_.clear();
  for (const Index i : hit_) hits_[i] = 0;
  hit_.clear();
  linked_.clear();
  resolved_.clear();
  book_.begin_instant();
  keep_slides();
  past_counts_ = counts_;
  past_log_ = log_ != nullptr ? log_->impacts.size() : 0;
}

template <class P>
void Tile<P>::remember(Index i) {
  if (motion_.fixed(disks_[i]) || is_past(i)) return;
  is_past_[i] = 1;
  past_.push_back({i, disks_[i], spins_.empty() ? S(0) : spins_[i], left(i)});
}

template <class P>
std::vector<Index> Tile<P>::take_back() {
  std::vector<Index> balls;
  for (const Past& past : past_) {
    const Index k = past.ball;
    unlink(k);
    const Time leaves = disks_[k].leaves;
    disks_[k] = past.disk;
    disks_[k].leaves = leaves;
    if (!spins_.empty()) spins_[k] = past.spin;
    if (!left_.empty()) left_[k] = past.left;
    forget(k);
    is_past_[k] = 0;
    balls.push_back(k);
  }
  past_.clear();
  resolved_.clear();
  for (const auto& [i, partner] : std::exchange(pressed_, {})) {
    for (const Index k : {i, partner}) {
      if (k >= kFirstMark || motion_.fixed(disks_[k])) continue;
      if (std::find(balls.begin(), balls.end(), k) == balls.end()) balls.push_back(k);
    }
  }
  counts_ = past_counts_;
  book_.take_back();
  if (log_ != nullptr) log_->impacts.resize(past_log_);
  return balls;
}

template <class P>
bool Tile<P>::is_late(Index i, At now) {
  if (motion_.fixed(disks_[i]) || is_past(i)) return false;
  const Disk& me = disks_[i];
  for (const Past& past : past_) {
    const Disk& other = past.disk;
    const bool meets =
        motion_.pair_meets(me, other, false, now) <= now && motion_.rules().collisions;
    if (!meets) continue;
    const Index ball = past.ball;
    forget(i);
    linked_.push_back({i, ball});
    meet_jointly(i, ball, now);
    return true;
  }
  return false;
}

inline bool has_pair(const std::vector<std::pair<Index, Index>>& pairs, Index i, Index j) {
  return std::any_of(pairs.begin(), pairs.end(), [&](const std::pair<Index, Index>& pair) {
    return (pair.first == i && pair.second == j) || (pair.first == j && pair.second == i);
  });
}

template <class P>
bool Tile<P>::is_linked(Index i, Index j) const {
  return has_pair(linked_, i, j);
}

template <class P>
bool Tile<P>::is_resolved(Index i, Index j) const {
  return has_pair(linked_, i, j) || has_pair(resolved_, i, j);
}

template <class P>
void Tile<P>::add_contact(Instant& instant, std::size_t member, Index j, At now, bool meets) {
  const Index i = instant.members[member];
  const std::size_t other = instant.find(j);
  const bool known = other < instant.members.size();
  const Vec<S> there =
      known ? instant.places[other] : motion_.wrapped(motion_.place(disks_[j], now));
  const Vec<S> r = motion_.way(instant.places[member], there);
  if (!meets && !touch(i, j, now, r)) return;
  if (!known) add_member(instant, j, now);
  // What touches a crowd is resolved with it.
  if (motion_.hops() && (motion_.crowded(disks_[i]) || motion_.crowded(disks_[j]))) return;
  // Each pair once: with the later of its balls, or the one that is not fixed.
  if (other > member && !motion_.fixed(disks_[j])) return;
  instant.contacts.push_back({static_cast<int>(member), static_cast<int>(other), r,
                              S(gives_up() ? 0 : motion_.rules().restitution)});
}

template <class P>
void Tile<P>::add_contacts(Instant& instant, std::size_t member, At now) {
  const Index i = instant.members[member];
  const Disk& disk = disks_[i];
  const auto& rules = motion_.rules();
  if (motion_.fixed(disk)) return;
  const bool crowded = motion_.hops() && motion_.crowded(disk);
  for (Index wall = kWalls; wall < kWalls + 4 && !crowded; ++wall) {
    if (!rules.domain.solid((wall - kWalls) / 2)) continue;
    const S gap = motion_.wall(disk, instant.places[member], wall).gap;
    const bool near = jams_ > 0 && !(gap > 2 * motion_.kind(disk).radius * jam_gap());
    const bool meets = !(gap > 0) || motion_.wall_meets(disk, wall) == now || is_linked(i, wall);
    if (!meets && !near) continue;
    const S side = wall % 2 == kWalls % 2 ? -1 : 1;
    const Vec<S> towards = wall - kWalls < 2 ? Vec<S>{side, S(0)} : Vec<S>{S(0), side};
    instant.stops.push_back({member, wall, meets});
    instant.contacts.push_back(
        {static_cast<int>(member), kWall, towards, S(gives_up() ? 0 : rules.wall_restitution)});
  }
  if (!rules.collisions) return;
  std::vector<Index> linked;
  for (const auto& [a, b] : linked_) {
    if (a != i && b != i) continue;
    const Index j = a == i ? b : a;
    if (j < kFirstMark) linked.push_back(j);
  }
  neighbours_.lists().each(i, [&](Index j) {
    if (crowded && (motion_.fixed(disks_[j]) || motion_.crowded(disks_[j]))) return;
    const auto known = std::find(linked.begin(), linked.end(), j);
    const bool meets = known != linked.end();
    if (meets) linked.erase(known);
    add_contact(instant, member, j, now, meets);
  });
  for (const Index j : linked) add_contact(instant, member, j, now, true);
}

// Whether one of a crowd touches, two cling to each other, or they are too many.
template <class P>
bool Tile<P>::is_of_crowd(const Instant& instant, At now) const {
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
auto Tile<P>::touching(std::vector<Index>& seeds, At now) -> Instant {
  Instant instant;
  add_member(instant, seeds.front(), now);
  for (std::size_t k = 0; k < instant.members.size(); ++k) add_contacts(instant, k, now);
  const auto found = [&](Index seed) { return instant.find(seed) < instant.members.size(); };
  seeds.erase(std::remove_if(seeds.begin(), seeds.end(), found), seeds.end());
  return instant;
}

// What has been resolved at this instant, and now shares a ball with more, is resolved again.
template <class P>
void Tile<P>::meet_jointly(Index i, Index partner, At now) {
  if (!is_linked(i, partner)) linked_.push_back({i, partner});
  std::vector<Index> seeds;
  const auto start = [&] {
    if (std::find(seeds.begin(), seeds.end(), i) == seeds.end()) seeds.push_back(i);
  };
  start();
  // Of both it is not known any more what they meet next.
  const bool two = partner < kFirstMark && !motion_.fixed(disks_[partner]);
  const auto unknown = [&](std::vector<Index> balls) {
    if (two) balls.push_back(partner);
    return balls;
  };
  std::vector<Index> looked_for = unknown(seeds);
  std::vector<Instant> groups;
  groups.push_back(touching(seeds, now));
  const std::vector<Index>& members = groups.front().members;
  if (std::any_of(members.begin(), members.end(), [this](Index m) { return is_past(m); })) {
    seeds = take_back();
    start();
    looked_for = unknown(seeds);
    groups.clear();
  }
  while (!seeds.empty()) groups.push_back(touching(seeds, now));
  std::vector<std::vector<Index>> crowds;
  std::vector<Instant> others;
  for (Instant& group : groups) {
    if (!motion_.hops() || !is_of_crowd(group, now)) {
      others.push_back(std::move(group));
      continue;
    }
    std::vector<Index>& crowd = crowds.emplace_back();
    std::copy_if(group.members.begin(), group.members.end(), std::back_inserter(crowd),
                 [this](Index m) { return !motion_.fixed(disks_[m]); });
  }
  hit_crowds(std::move(crowds), now);
  for (Instant& group : others) resolve_group(group, looked_for, now);
}

// Of several fixed balls that it touches the flight began at the one that lies first, by place.
template <class P>
void Tile<P>::note_left(const Instant& instant, At now) {
  std::vector<const Vec<S>*> ways(instant.members.size(), nullptr);
  for (const Contact<S>& contact : instant.contacts) {
    if (contact.b == kWall) continue;
    const auto a = static_cast<std::size_t>(contact.a);
    const Index b = instant.members[static_cast<std::size_t>(contact.b)];
    const Index ball = instant.members[a];
    if (!motion_.fixed(disks_[b]) || disks_[ball].start != now) continue;
    const Vec<S>* first = ways[a];
    const Vec<S>& r = contact.r;
    if (first != nullptr && (first->x < r.x || (first->x == r.x && first->y < r.y))) continue;
    ways[a] = &r;
    left_[ball] = b;
  }
}

template <class P>
void Tile<P>::resolve_group(Instant& instant, const std::vector<Index>& looked_for, At now) {
  for (const Index m : instant.members) remember(m);
  // Nothing else touches: it is an impact like others, however it came to be looked at.
  if (instant.contacts.size() == 1 && instant.members.size() < 3) {
    const Contact<S>& contact = instant.contacts.front();
    const Index i = instant.members[static_cast<std::size_t>(contact.a)];
    const Index partner = contact.b == kWall ? instant.stops.front().wall
                                             : instant.members[static_cast<std::size_t>(contact.b)];
    const bool ball = partner < kFirstMark && !motion_.fixed(disks_[partner]);
    const Disk was = disks_[i];
    const Disk partner_was = ball ? disks_[partner] : Disk{};
    for (const Index k : {i, partner}) {
      if (k == partner && !ball) continue;
      unlink(k);
      forget(k);
    }
    meet_alone(i, partner, now);
    const double lost = book_.keep();
    if (log_ != nullptr) log_alone(i, partner, was, partner_was, lost, now);
    if (ball) look_again(partner, now);
    look_again(i, now);
    return;
  }

  std::size_t stops = 0;
  for (const Contact<S>& contact : instant.contacts) {
    const Index other = contact.b == kWall ? instant.stops[stops++].wall
                                           : instant.members[static_cast<std::size_t>(contact.b)];
    resolved_.push_back({instant.members[static_cast<std::size_t>(contact.a)], other});
  }
  const std::vector<Body<S>> before = instant.bodies;
  const std::vector<S> spins_before = instant.spins;
  ++counts_.joint_impacts;
  JointLog joint;
  const JointReport report = resolve(instant, log_ != nullptr ? &joint : nullptr);
  const std::size_t first_line = log_ != nullptr ? log_->impacts.size() : 0;
  if (log_ != nullptr) log_joint(instant, joint, now);
  const auto walls = static_cast<std::uint64_t>(report.walls);
  const auto balls = static_cast<std::uint64_t>(report.impacts);
  counts_.ball_wall += walls;
  counts_.ball_ball += balls;
  counts_.jammed +=
      gives_up() ? instant.contacts.size() : static_cast<std::uint64_t>(report.jammed);
  book_.note(report.lost);
  double lost = book_.keep();

  std::vector<Index> changed;
  for (std::size_t k = 0; k < instant.members.size(); ++k) {
    const Index m = instant.members[k];
    Disk& disk = disks_[m];
    if (motion_.fixed(disk)) continue;
    bool same = before[k].velocity == instant.bodies[k].velocity;
    if (!spins_.empty()) same = same && spins_before[k] == instant.spins[k];
    const bool looks = std::find(looked_for.begin(), looked_for.end(), m) != looked_for.end();
    if (same && !looks) continue;
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
    if (!left_.empty() && !same) left_[m] = kUnknown;
  }
  for (const typename Instant::Stop& stop : instant.stops) {
    Disk& disk = disks_[instant.members[stop.member]];
    // To move the others would take the energy of their height.
    if (disk.start != now || !stop.meets) continue;
    const S at = motion_.wall(disk, {disk.x, disk.y}, stop.wall).stop;
    (stop.wall - kWalls < 2 ? disk.x : disk.y) = at;
  }
  if (!left_.empty()) note_left(instant, now);
  for (const Index m : changed) lean(m);
  lost += book_.keep();
  log_loss(first_line, lost);
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
  for (const Index m : changed) look_again(m, now);
}

}  // namespace carom::event
