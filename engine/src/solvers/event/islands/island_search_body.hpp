#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "contact/cone_island.hpp"
#include "contact/rest_rules.hpp"
#include "solvers/event/islands/island_order.hpp"
#include "solvers/event/islands/island_search.hpp"
#include "solvers/event/islands/lasting_speed.hpp"
#include "solvers/event/islands/put_on_wall.hpp"

namespace carom::event {

template <class P>
auto IslandSearch<P>::of(const std::vector<Index>& balls, At now, Time until) -> Island {
  Island island;
  if (!motion_.elastic()) island.few = kFewOfHeap;
  for (const Index i : balls) {
    if (number_[i] < 0) join(island, i, now);
  }
  const std::size_t given = island.members.size();
  if (motion_.rules().collisions) {
    add_near(island, 0, now, true);
    if (is_large(island)) add_coming(island, now, until);
  }
  for (const Index m : island.members) number_[m] = -1;
  if (is_large(island)) put_in_order(island);
  island.complete = island.members.size() == given;
  return island;
}

template <class P>
int IslandSearch<P>::large_of(const std::vector<Island>& islands,
                              const std::vector<Index>& balls) const {
  for (const Index i : balls) {
    if (owner_[i] >= 0 && is_large(islands[static_cast<std::size_t>(owner_[i])])) return owner_[i];
  }
  return -1;
}

// A large island is in order by place, whatever it was found from: what begins with one of it is
// not looked for before it is known what else there is, nor what is complete for each of its hits.
template <class P>
void IslandSearch<P>::add(std::vector<Island>& islands, std::vector<Index> balls, At now,
                          Time until) {
  const auto own = [this](const Island& island, std::size_t number) {
    for (const Index m : island.members) owner_[m] = static_cast<int>(number);
  };
  for (;;) {
    int owner = large_of(islands, balls);
    if (owner < 0) {
      Island island = of(balls, now, until);
      const auto shared = std::find_if(island.members.begin(), island.members.end(),
                                       [this](Index m) { return owner_[m] >= 0; });
      if (shared == island.members.end()) {
        own(island, islands.size());
        islands.push_back(std::move(island));
        return;
      }
      owner = owner_[*shared];
    }
    // A ball that an earlier island has brings its island with it.
    Island& other = islands[static_cast<std::size_t>(owner)];
    if (is_large(other) && other.complete &&
        std::all_of(balls.begin(), balls.end(), [&](Index i) { return owner_[i] == owner; })) {
      own(other, islands.size());
      islands.push_back(std::exchange(other, Island()));
      return;
    }
    for (const Index m : other.members) owner_[m] = -1;
    balls.insert(balls.end(), other.members.begin(), other.members.end());
    other = Island();
  }
}

template <class P>
void IslandSearch<P>::finish(std::vector<Island>& islands) {
  for (const Island& island : islands) {
    for (const Index m : island.members) owner_[m] = -1;
  }
  std::erase_if(islands, [](const Island& island) { return island.members.empty(); });
}

template <class P>
auto IslandSearch<P>::of_step(const std::vector<Index>& balls, At now, Time until)
    -> std::vector<Island> {
  ends_ = now;
  std::vector<Island> islands;
  for (const Index i : balls) {
    if (owner_[i] < 0) add(islands, {i}, now, until);
  }
  finish(islands);
  if (!motion_.elastic_impacts()) {
    for (Island& island : islands) note_bounces(island);
  }
  return islands;
}

// A step would hold them as contacts that last, without their restitution.
template <class P>
void IslandSearch<P>::note_bounces(Island& island) const {
  const auto steps = [&](int body) {
    return body == kWall || island.support[static_cast<std::size_t>(body)] >= kResting;
  };
  const auto seconds = static_cast<double>(motion_.seconds_of_step());
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const double speed = approach(island, k);
    if (!steps(c.a) || !steps(c.b) || !(c.gap <= speed * seconds)) continue;
    const auto lasting = static_cast<double>(lasting_speed(motion_, island, k));
    island.near[k].comes = island.near[k].comes || speed > lasting;
  }
}

template <class P>
auto IslandSearch<P>::of_hits(const std::vector<std::vector<Index>>& groups, At now)
    -> std::vector<Island> {
  ends_ = next_step_;
  // Those that touch become one island, though none of them is of one yet.
  const auto mark = [&](char joins) {
    for (const auto& balls : groups) {
      for (const Index i : balls) joins_[i] = joins;
    }
  };
  mark(1);
  std::vector<Island> islands;
  for (const std::vector<Index>& balls : groups) add(islands, balls, now, next_step_);
  mark(0);
  finish(islands);
  return islands;
}

template <class P>
void IslandSearch<P>::join(Island& island, Index i, At now) {
  const Disk& disk = disks_[i];
  number_[i] = static_cast<int>(island.members.size());
  island.members.push_back(i);
  island.support.push_back(motion_.support(disk));
  Vec<S> at = motion_.wrapped(motion_.place(disk, now));
  const auto& species = motion_.species(disk);
  S turning = 0;
  if (!spins_.empty()) turning = species.radius * motion_.spin_at(disk, spins_[i], now);
  island.bodies.push_back({in_double(motion_.velocity(disk, now)), static_cast<double>(turning),
                           static_cast<double>(species.inverse_mass)});
  const bool ends = ends_ != P::Clock::never();
  island.gravity.push_back(ends ? motion_.gravity_of(disk, now, ends_) : GravityOfFlight{});
  if (!left_out_.empty()) island.left_out.push_back(left_out_[i]);
  for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
    const std::size_t axis = (wall - kWalls) / 2;
    if (!motion_.rules().domain.solid(axis)) continue;
    const S gap = motion_.wall(disk, at, wall).gap;
    if (gap > 2 * species.radius * kNear) continue;
    if (gap < 0) island.lifted += put_on_wall(motion_, disk, wall, at);
    const S side = wall % 2 == kWalls % 2 ? -1 : 1;
    const Vec<S> towards = axis == 0 ? Vec<S>{side, S(0)} : Vec<S>{S(0), side};
    island.contacts.push_back({number_[i], kWall, in_double(towards),
                               static_cast<double>(larger(gap, S(0))),
                               motion_.rules().wall_friction});
    island.near.push_back({towards, wall});
    island.touches.push_back(gap > 2 * species.radius * kTouching ? 0 : 1);
  }
  island.places.push_back(at);
}

// The near contacts of the members from `first` on, which are the last ones.  `joins`: what they
// are with becomes a member if it is of an island.
template <class P>
void IslandSearch<P>::add_near(Island& island, std::size_t first, At now, bool joins) {
  const double friction = motion_.rules().friction;
  std::vector<Index> around;
  for (std::size_t m = first; m < island.members.size(); ++m) {
    const Index i = island.members[m];
    const Vec<S> here = island.places[m];
    const S radius = motion_.species(disks_[i]).radius;
    const auto found = neighbours_.around(static_cast<double>(here.x), static_cast<double>(here.y));
    around.assign(found.begin(), found.end());
    for (const Index j : around) {
      if (j == i || number_[j] > number_[i]) continue;  // it is found from there, too
      const bool fixed = motion_.fixed(disks_[j]);
      const bool brings = joins && (motion_.in_island(disks_[j]) || joins_[j] != 0);
      if (number_[j] < 0 && !fixed && !brings) continue;
      const S reach = radius + motion_.species(disks_[j]).radius;
      const Vec<S> there = number_[j] >= 0 ? island.places[static_cast<std::size_t>(number_[j])]
                                           : motion_.wrapped(motion_.place(disks_[j], now));
      const Vec<S> r = motion_.way(here, there);
      if (!near(r, reach, S(kNear))) continue;
      if (number_[j] < 0 && !fixed) join(island, j, now);
      if (!fixed && number_[j] > number_[i]) continue;
      const S length = root(S(r.x * r.x + r.y * r.y));
      const S gap = squared_gap(r, reach) / (length + reach);
      island.contacts.push_back({number_[i], fixed ? kWall : number_[j],
                                 in_double(S(1 / length) * r), static_cast<double>(gap), friction});
      island.near.push_back({r, fixed ? j : kUnknown});
      island.touches.push_back(near(r, reach, S(kTouching)) ? 1 : 0);
      const S depth = -gap / std::min(radius, motion_.species(disks_[j]).radius);
      island.deepest = std::max(island.deepest, static_cast<double>(depth));
    }
  }
}

}  // namespace carom::event
