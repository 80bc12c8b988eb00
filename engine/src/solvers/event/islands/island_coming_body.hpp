#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "contact/rest_rules.hpp"
#include "solvers/event/islands/island_search.hpp"

namespace carom::event {

// The balls that will meet one of the island before its next step, and are near it by then: a step
// of a heap sees many, and each would be an impact of the whole heap.
template <class P>
void IslandSearch<P>::add_coming(Island& island, At now) {
  if (motion_.elastic() || next_step_ == P::Clock::never()) return;
  struct Coming {
    Index of_island;
    Index ball;
    Time at;
  };
  std::vector<Coming> coming;
  const std::size_t first = island.members.size();
  for (std::size_t m = 0; m < first; ++m) {
    const Index i = island.members[m];
    const Disk& disk = disks_[i];
    if (!motion_.in_island(disk)) continue;
    const Vec<S> here = island.places[m];
    const S radius = motion_.species(disk).radius;
    for (const Index j :
         neighbours_.around(static_cast<double>(here.x), static_cast<double>(here.y))) {
      const Disk& other = disks_[j];
      if (motion_.fixed(other) || motion_.in_island(other)) continue;
      const Vec<S> r = motion_.way(here, motion_.place(other, now));
      if (!near(r, S(radius + motion_.species(other).radius), S(kAhead))) continue;
      const Vec<S> v = motion_.velocity(other, now) - motion_.velocity(disk, now);
      if (!(dot(r, v) < 0)) continue;
      const Time at = motion_.pair_event(disk, other, false, next_step_);
      if (at > now && at <= next_step_) coming.push_back({i, j, at});
    }
  }
  for (const Coming& pair : coming) {
    if (number_[pair.ball] < 0) join(island, pair.ball, now);
  }
  add_near(island, first, now, false);
  const double friction = motion_.rules().friction;
  for (const Coming& pair : coming) {
    const int a = number_[pair.of_island];
    const int b = number_[pair.ball];
    const auto joins = [&](const ConeContact& c) {
      return (c.a == a && c.b == b) || (c.a == b && c.b == a);
    };
    auto k = static_cast<std::size_t>(
        std::find_if(island.contacts.begin(), island.contacts.end(), joins) -
        island.contacts.begin());
    if (k == island.contacts.size()) {
      const Disk& disk = disks_[pair.of_island];
      const Disk& other = disks_[pair.ball];
      const Vec<S> r = motion_.way(island.places[static_cast<std::size_t>(a)],
                                   island.places[static_cast<std::size_t>(b)]);
      const S reach = motion_.species(disk).radius + motion_.species(other).radius;
      const S gap = squared_gap(r, reach) / (root(S(r.x * r.x + r.y * r.y)) + reach);
      island.contacts.push_back({a, b, {}, static_cast<double>(gap), friction});
      island.near.push_back({r, kUnknown});
      island.touches.push_back(0);
    }
    // It is hit the way it will be then.
    ConeContact& contact = island.contacts[k];
    const Index one = island.members[static_cast<std::size_t>(contact.a)];
    const Index other = island.members[static_cast<std::size_t>(contact.b)];
    const Vec<S> r =
        motion_.way(motion_.place(disks_[one], pair.at), motion_.place(disks_[other], pair.at));
    contact.normal = in_double(S(1 / root(S(r.x * r.x + r.y * r.y))) * r);
    island.near[k].comes = island.touches[k] == 0;
  }
}

}  // namespace carom::event
