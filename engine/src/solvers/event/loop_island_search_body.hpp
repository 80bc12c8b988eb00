#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "contact/cone_island.hpp"
#include "contact/rest_rules.hpp"
#include "solvers/event/event_loop.hpp"

namespace carom::event {

template <class S>
bool precedes_by_place(const Vec<S>& one, const Vec<S>& other) {
  return one.x < other.x || (one.x == other.x && one.y < other.y);
}

// Moves a ball along an axis, onto a wall.
template <class P>
void EventLoop<P>::put_at(FoundIsland& island, Vec<S>& at, std::size_t axis, const S& stop,
                          const S& inverse_mass) const {
  S& x = axis == 0 ? at.x : at.y;
  island.lifted += static_cast<double>(S((x - stop) * motion_.law().pull(axis) / inverse_mass));
  x = stop;
}

template <class P>
void EventLoop<P>::join(FoundIsland& island, Index i, At now) {
  Disk& disk = disks_[i];
  number_[i] = static_cast<int>(island.members.size());
  island.members.push_back(i);
  island.support.push_back(motion_.support(disk));
  Vec<S> at = motion_.wrapped(motion_.place(disk, now));
  const auto& species = motion_.species(disk);
  S turning = 0;
  if (!spins_.empty()) turning = species.radius * motion_.spin_at(disk, spins_[i], now);
  island.bodies.push_back({in_double(motion_.velocity(disk, now)), static_cast<double>(turning),
                           static_cast<double>(species.inverse_mass)});
  for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
    const std::size_t axis = (wall - kWalls) / 2;
    if (!motion_.rules().domain.solid(axis)) continue;
    const auto [gap, stop] = motion_.wall(disk, at, wall);
    if (gap > 2 * species.radius * kNear) continue;
    if (gap < 0) put_at(island, at, axis, stop, species.inverse_mass);
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

// All balls that can be reached from the members over near contacts of balls that are of an island,
// or are about to be. `ahead`: where there are many, also those that come to them before the next
// step.
template <class P>
void EventLoop<P>::gather(FoundIsland& island, At now, bool ahead) {
  if (motion_.rules().collisions) {
    add_near(island, 0, now, true);
    const bool many = island.contacts.size() > kFewContacts;
    if (many && ahead) add_coming(island, now);
  }
  for (const Index m : island.members) number_[m] = -1;
  if (island.contacts.size() > kFewContacts) put_in_order(island);
}

// The near contacts of the members from `first` on, which are the last ones.  `joins`: what they
// are with becomes a member if it is of an island.
template <class P>
void EventLoop<P>::add_near(FoundIsland& island, std::size_t first, At now, bool joins) {
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
      counts_.max_overlap = std::max(counts_.max_overlap, static_cast<double>(depth));
    }
  }
}

// By place, which no numbering changes.
template <class P>
void EventLoop<P>::put_in_order(FoundIsland& island) {
  const auto sorted = [](std::size_t n, const auto& before) {
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), before);
    return order;
  };
  const auto rearrange = [](auto& column, const std::vector<std::size_t>& order) {
    auto old = column;
    for (std::size_t k = 0; k < order.size(); ++k) column[k] = std::move(old[order[k]]);
  };
  const std::vector<std::size_t> order =
      sorted(island.members.size(), [&](std::size_t one, std::size_t other) {
        return precedes_by_place(island.places[one], island.places[other]);
      });
  rearrange(island.members, order);
  rearrange(island.places, order);
  rearrange(island.support, order);
  rearrange(island.bodies, order);
  std::vector<int> number(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = static_cast<int>(k);
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    ConeContact& c = island.contacts[k];
    c.a = number[static_cast<std::size_t>(c.a)];
    if (c.b == kWall) continue;
    c.b = number[static_cast<std::size_t>(c.b)];
    if (c.a < c.b) continue;
    std::swap(c.a, c.b);
    c.normal = -c.normal;
    island.near[k].r = -island.near[k].r;
  }
  const std::vector<std::size_t> in_turn =
      sorted(island.contacts.size(), [&](std::size_t one, std::size_t other) {
        const ConeContact& c = island.contacts[one];
        const ConeContact& d = island.contacts[other];
        if (c.a != d.a) return c.a < d.a;
        if (c.b != d.b) return c.b < d.b;
        return precedes_by_place(c.normal, d.normal);
      });
  rearrange(island.contacts, in_turn);
  rearrange(island.near, in_turn);
  rearrange(island.touches, in_turn);
}

// Every member begins the flight that `island` says, by its `support`.
template <class P>
double EventLoop<P>::fly_on(FoundIsland& island, At now) {
  bool moves = false;
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    const Index i = island.members[m];
    remember(i);
    schedule_.unlink(i);
    schedule_.forget(i);
    Disk& disk = disks_[i];
    disk.x = island.places[m].x;
    disk.y = island.places[m].y;
    disk.vx = with_plain_zero(island.bodies[m].velocity.x);
    disk.vy = with_plain_zero(island.bodies[m].velocity.y);
    if (!spins_.empty()) spins_[i] = island.bodies[m].turning / motion_.species(disk).radius;
    disk.start = now;
    motion_.set_support(disk, island.support[m]);
    left_[i] = kUnknown;
    moves = moves || island.support[m] == kStepped;
  }
  // Of several fixed balls that it touches, the one that lies first, by place.
  std::vector<const Vec<S>*> ways(island.members.size(), nullptr);
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const auto a = static_cast<std::size_t>(island.contacts[k].a);
    const auto& near = island.near[k];
    if (island.support[a] >= kResting || island.touches[k] == 0 || near.partner >= kFirstMark)
      continue;
    if (ways[a] != nullptr && precedes_by_place(*ways[a], near.r)) continue;
    ways[a] = &near.r;
    left_[island.members[a]] = near.partner;
  }
  if (moves) schedule_step(now);
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    if (island.support[m] < kResting) update_support(island.members[m]);
  }
  const double lost = book_.keep();
  changed_.insert(changed_.end(), island.members.begin(), island.members.end());
  return lost;
}

}  // namespace carom::event
