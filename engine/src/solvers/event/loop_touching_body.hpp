#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "contact/rest_rules.hpp"
#include "solvers/event/loop_island_search_body.hpp"

namespace carom::event {

template <class P>
bool EventLoop<P>::tied(Index i, Index partner, At now) {
  if (!ties_.any(now, i, partner)) return false;
  // A tie may be of what was known of a ball before: whether it was noted depends on what was
  // looked at when.
  const bool ball = partner < kFirstMark && !motion_.fixed(disks_[partner]);
  return meets_another(i, partner, now) || (ball && meets_another(partner, i, now));
}

// Whether the ball meets something else at this instant, too.
template <class P>
bool EventLoop<P>::meets_another(Index i, Index partner, At now) const {
  const Disk& disk = disks_[i];
  for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
    if (wall == partner || !motion_.rules().domain.solid((wall - kWalls) / 2)) continue;
    if (motion_.wall_event(disk, wall) <= now) return true;
  }
  if (!motion_.rules().collisions) return false;
  bool meets = false;
  neighbours_.lists().each(i, [&](Index j) {
    if (meets || j == partner) return;
    meets = prediction_.pair_event(i, j, now) <= now;
  });
  return meets;
}

template <class P>
bool EventLoop<P>::touch(Index i, Index j, At now, const Vec<S>& r) const {
  const Disk& a = disks_[i];
  const Disk& b = disks_[j];
  const S reach = motion_.species(a).radius + motion_.species(b).radius;
  if (!(squared_gap(r, reach) > 0)) return true;
  const JamLevel& jam = jam_watch_.level();
  if (jam.jammed() && near(r, reach, S(jam.gap()))) return true;
  if (motion_.clusters() &&
      near(r, S(motion_.species(a).radius + motion_.species(b).radius), S(kTouching / 32)) &&
      motion_.collapses(a, b, now)) {
    return true;
  }
  return prediction_.pair_event(i, j, now) == now;
}

template <class P>
void EventLoop<P>::add_member(SimultaneousImpact& group, Index i, At now) const {
  const Disk& disk = disks_[i];
  group.members.push_back(i);
  group.places.push_back(motion_.wrapped(motion_.place(disk, now)));
  group.bodies.push_back({motion_.velocity(disk, now), motion_.species(disk).inverse_mass});
  if (!spins_.empty()) group.spins.push_back(motion_.spin_at(disk, spins_[i], now));
}

template <class P>
bool EventLoop<P>::is_late(Index i, At now) {
  if (motion_.fixed(disks_[i]) || resolutions_.contains(i)) return false;
  const Disk& me = disks_[i];
  for (const typename FlightsBefore<P>::Before& before : before_.all()) {
    const Disk& other = before.disk;
    const bool meets =
        motion_.pair_event(me, other, false, now) <= now && motion_.rules().collisions;
    if (!meets) continue;
    schedule_.forget(i);
    pairs_.wait(i, before.ball);
    return true;
  }
  return false;
}

template <class P>
void EventLoop<P>::add_contact(SimultaneousImpact& group, std::size_t member, Index j, At now,
                               bool meets) {
  const Index i = group.members[member];
  const std::size_t other = group.find(j);
  const bool known = other < group.members.size();
  const Vec<S> there = known ? group.places[other] : motion_.wrapped(motion_.place(disks_[j], now));
  const Vec<S> r = motion_.way(group.places[member], there);
  if (!meets && !touch(i, j, now, r)) return;
  if (!known) add_member(group, j, now);
  // What touches an island is resolved with it.
  if (motion_.contacts_last() && (motion_.in_island(disks_[i]) || motion_.in_island(disks_[j])))
    return;
  // Each pair once: with the later of its balls, or the one that is not fixed.
  if (other > member && !motion_.fixed(disks_[j])) return;
  group.contacts.push_back({static_cast<int>(member), static_cast<int>(other), r,
                            S(gives_up() ? 0 : motion_.rules().restitution)});
}

template <class P>
void EventLoop<P>::add_contacts(SimultaneousImpact& group, std::size_t member, At now) {
  const Index i = group.members[member];
  const Disk& disk = disks_[i];
  const auto& rules = motion_.rules();
  if (motion_.fixed(disk)) return;
  const bool in_island = motion_.contacts_last() && motion_.in_island(disk);
  const JamLevel& jam = jam_watch_.level();
  for (Index wall = kWalls; wall < kWalls + 4 && !in_island; ++wall) {
    if (!rules.domain.solid((wall - kWalls) / 2)) continue;
    const S gap = motion_.wall(disk, group.places[member], wall).gap;
    const bool near = jam.jammed() && !(gap > 2 * motion_.species(disk).radius * jam.gap());
    const bool meets =
        !(gap > 0) || motion_.wall_event(disk, wall) == now || pairs_.is_linked(i, wall);
    if (!meets && !near) continue;
    const S side = wall % 2 == kWalls % 2 ? -1 : 1;
    const Vec<S> towards = wall - kWalls < 2 ? Vec<S>{side, S(0)} : Vec<S>{S(0), side};
    group.stops.push_back({member, wall, meets});
    group.contacts.push_back(
        {static_cast<int>(member), kWall, towards, S(gives_up() ? 0 : rules.wall_restitution)});
  }
  if (!rules.collisions) return;
  std::vector<Index> linked;
  for (const auto& [a, b] : pairs_.linked()) {
    if (a != i && b != i) continue;
    const Index j = a == i ? b : a;
    if (j < kFirstMark) linked.push_back(j);
  }
  neighbours_.lists().each(i, [&](Index j) {
    if (in_island && (motion_.fixed(disks_[j]) || motion_.in_island(disks_[j]))) return;
    const auto known = std::find(linked.begin(), linked.end(), j);
    const bool meets = known != linked.end();
    if (meets) linked.erase(known);
    add_contact(group, member, j, now, meets);
  });
  for (const Index j : linked) add_contact(group, member, j, now, true);
}

// Whether one of an island touches, two cling to each other, or they are too many.
template <class P>
bool EventLoop<P>::is_of_island(const SimultaneousImpact& group, At now) const {
  // Elastic ones part again.
  if (motion_.rules().restitution < 1 && group.contacts.size() > kManyContacts) return true;
  for (const Index m : group.members) {
    if (motion_.in_island(disks_[m])) return true;
  }
  return std::any_of(group.contacts.begin(), group.contacts.end(), [&](const Contact<S>& contact) {
    if (contact.b == kWall) return false;
    const auto a = static_cast<std::size_t>(contact.a);
    const auto b = static_cast<std::size_t>(contact.b);
    const Vec<S> v = group.bodies[b].velocity - group.bodies[a].velocity;
    return !(sharp_dot(contact.r, v) > 0) &&
           motion_.sticks(disks_[group.members[a]], disks_[group.members[b]], contact.r, now);
  });
}

template <class P>
auto EventLoop<P>::touching(std::vector<Index>& seeds, At now) -> SimultaneousImpact {
  SimultaneousImpact group;
  add_member(group, seeds.front(), now);
  for (std::size_t k = 0; k < group.members.size(); ++k) add_contacts(group, k, now);
  const auto found = [&](Index seed) { return group.find(seed) < group.members.size(); };
  seeds.erase(std::remove_if(seeds.begin(), seeds.end(), found), seeds.end());
  return group;
}

// The groups of balls that touch, from these on. What has been resolved at this instant, and now
// shares a ball with more, is taken back: its balls are looked for, too.
template <class P>
auto EventLoop<P>::groups_of(std::vector<Index>& to_predict, At now)
    -> std::vector<SimultaneousImpact> {
  for (;;) {
    std::vector<Index> seeds = to_predict;
    std::vector<SimultaneousImpact> groups;
    std::vector<Index> past;
    while (!seeds.empty()) {
      groups.push_back(touching(seeds, now));
      const std::vector<Index>& members = groups.back().members;
      std::copy_if(members.begin(), members.end(), std::back_inserter(past),
                   [this](Index m) { return resolutions_.contains(m); });
    }
    if (past.empty()) return groups;
    take_back(past);
    for (const Index k : past) {
      if (std::find(to_predict.begin(), to_predict.end(), k) == to_predict.end()) {
        to_predict.push_back(k);
      }
    }
  }
}

}  // namespace carom::event
