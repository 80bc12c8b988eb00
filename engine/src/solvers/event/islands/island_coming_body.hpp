#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "contact/rest_rules.hpp"
#include "solvers/event/islands/island_search.hpp"

namespace carom::event {

// An impact between these and the island would pass through all of it, again and again until the
// next step.  A pair is noted by the one that is known later.
template <class P>
void IslandSearch<P>::add_coming(Island& island, At now, Time until) {
  if (motion_.elastic() || until == now || until == P::Clock::never()) return;
  std::vector<Coming> coming;
  std::vector<Index> around;
  const std::size_t first = island.members.size();
  const std::size_t contacts = island.contacts.size();
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    const Index i = island.members[m];
    const Disk& disk = disks_[i];
    const Vec<S> here = island.places[m];
    const S radius = motion_.species(disk).radius;
    const auto found = neighbours_.around(static_cast<double>(here.x), static_cast<double>(here.y));
    around.assign(found.begin(), found.end());
    for (const Index j : around) {
      const Disk& other = disks_[j];
      if (j == i || motion_.fixed(other) || number_[j] > number_[i]) continue;
      const bool known = number_[j] >= 0;
      const S reach = radius + motion_.species(other).radius;
      const Vec<S> r = motion_.way(here, motion_.place(other, now));
      if (!near(r, reach, S(kAhead))) continue;
      const bool close = near(r, reach, S(kNear));
      const bool held = close && motion_.in_island(disk) && motion_.in_island(other);
      bool meets = false;
      if (!held && dot(r, motion_.velocity(other, now) - motion_.velocity(disk, now)) < 0) {
        const Time at = motion_.pair_event(disk, other, false, until);
        meets = at > now && at <= until;
        if (meets && known) coming.push_back({i, j, at, close});
      }
      const bool flies = motion_.flies(other) || motion_.in_island(other);
      if (!known && (meets || (close && flies))) join(island, j, now);
    }
  }
  add_near(island, first, now, false);
  // What flies to a wall or a fixed ball bounces off it, too.
  for (std::size_t k = contacts; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const Disk& disk = disks_[island.members[static_cast<std::size_t>(c.a)]];
    if (c.b != kWall || motion_.in_island(disk) || !(approach(island, k) > 0)) continue;
    const Index partner = island.near[k].partner;
    const Time at = partner >= kFirstMark ? motion_.wall_event(disk, partner)
                                          : motion_.pair_event(disk, disks_[partner], false, until);
    island.near[k].comes = at > now && at <= until;
  }
  for (const Coming& pair : coming) note_coming(island, pair);
}

template <class P>
void IslandSearch<P>::note_coming(Island& island, const Coming& pair) const {
  const int a = number_[pair.one];
  const int b = number_[pair.other];
  const auto joins = [&](const ConeContact& c) {
    return (c.a == a && c.b == b) || (c.a == b && c.b == a);
  };
  auto known = island.contacts.end();
  if (pair.close) known = std::find_if(island.contacts.begin(), island.contacts.end(), joins);
  const auto k = static_cast<std::size_t>(known - island.contacts.begin());
  if (k == island.contacts.size()) {
    const Vec<S> r = motion_.way(island.places[static_cast<std::size_t>(a)],
                                 island.places[static_cast<std::size_t>(b)]);
    island.contacts.push_back({a, b, {}, 0, motion_.rules().friction});
    island.near.push_back({r, kUnknown});
    island.touches.push_back(0);
  }
  // It is hit the way it will be then, and is so far away that way.
  ConeContact& contact = island.contacts[k];
  const Disk& one = disks_[island.members[static_cast<std::size_t>(contact.a)]];
  const Disk& other = disks_[island.members[static_cast<std::size_t>(contact.b)]];
  const Vec<S> then = motion_.way(motion_.place(one, pair.at), motion_.place(other, pair.at));
  const Vec<S> normal = S(1 / root(S(then.x * then.x + then.y * then.y))) * then;
  const S reach = motion_.species(one).radius + motion_.species(other).radius;
  contact.normal = in_double(normal);
  contact.gap = static_cast<double>(larger(S(dot(normal, island.near[k].r) - reach), S(0)));
  island.near[k].comes = true;
}

}  // namespace carom::event
