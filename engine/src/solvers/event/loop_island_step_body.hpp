#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/cone_island.hpp"
#include "contact/rest_rules.hpp"
#include "solvers/event/loop_island_search_body.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

template <class P>
void EventLoop<P>::step_islands(At now) {
  const Stopwatch stopwatch(true, costs_.island_seconds());
  std::vector<Index> all;
  for (Index i = 0; i < disks_.size(); ++i) {
    if (!motion_.fixed(disks_[i]) && motion_.support(disks_[i]) >= kStepped) all.push_back(i);
  }
  std::vector<char> stepped(disks_.size(), 0);
  resolutions_.begin();
  for (const Index i : all) {
    if (stepped[i] != 0) continue;
    FoundIsland island;
    join(island, i, now);
    gather(island, now, false);
    for (const Index m : island.members) stepped[m] = 1;
    step_island(island, now);
  }
  begin_simultaneous();  // what comes now takes no step back
  predict_changed(now);
}

// What is slow comes to rest only where forces at its contacts hold it: what is pulled moves on. Of
// many balls, which creep until all contacts carry, slowness decides.
template <class P>
void EventLoop<P>::hold_still(const FoundIsland& island, DisjointSets& sets,
                              const std::vector<char>& carries, std::vector<char>& moves) const {
  const std::size_t n = island.members.size();
  const auto find = [&sets](std::size_t k) { return sets.find(static_cast<std::uint32_t>(k)); };
  const double span =
      motion_.stepped_way(motion_.rules().scale.seconds(P::Clock::span(1, motion_.step_shift())));
  const auto speed = static_cast<double>(motion_.speed_of_step());
  const Vec<double> g = in_double(motion_.law().pull());
  for (std::size_t first = 0; first < n; ++first) {
    if (find(first) != first || moves[first] != 0) continue;
    std::vector<int> number(n, -1);
    std::vector<ConeBody> bodies;
    bool fresh = false;
    for (std::size_t m = 0; m < n; ++m) {
      if (find(m) != first) continue;
      number[m] = static_cast<int>(bodies.size());
      bodies.push_back({span * g, 0, island.bodies[m].inverse_mass});
      fresh = fresh || island.support[m] != kResting;
    }
    if (!fresh || bodies.size() > kFewHeld) continue;
    std::vector<ConeContact> contacts;
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      ConeContact contact = island.contacts[k];
      const int a = number[static_cast<std::size_t>(contact.a)];
      if (a < 0 || (carries[k] == 0 && !island.near[k].touches)) continue;
      contact.a = a;
      if (contact.b != kWall) contact.b = number[static_cast<std::size_t>(contact.b)];
      if (island.contacts[k].b != kWall && contact.b < 0) continue;
      contact.gap = 0;
      contacts.push_back(contact);
    }
    ConeIsland whole(bodies, contacts);
    whole.resolve(bodies, 0, kHeld / 4 * speed);
    for (const ConeBody& body : bodies) {
      const double most =
          std::max({std::abs(body.velocity.x), std::abs(body.velocity.y), std::abs(body.turning)});
      if (most > kHeld * speed) moves[first] = 1;
    }
  }
}

template <class P>
void EventLoop<P>::pass_on_motion(const FoundIsland& island, DisjointSets& sets,
                                  std::vector<char>& moves) const {
  for (bool more = true; more;) {
    more = false;
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      const ConeContact& c = island.contacts[k];
      if (c.b == kWall || !island.near[k].touches) continue;
      const std::uint32_t a = sets.find(static_cast<std::uint32_t>(c.a));
      const std::uint32_t b = sets.find(static_cast<std::uint32_t>(c.b));
      if (moves[a] == moves[b]) continue;
      const ConeBody& moving = island.bodies[static_cast<std::size_t>(moves[a] != 0 ? c.a : c.b)];
      const double nearer = dot(c.normal, moving.velocity) * (moves[a] != 0 ? 1 : -1);
      if (!(nearer > 0)) continue;
      moves[a] = moves[b] = 1;
      more = true;
    }
  }
}

template <class P>
std::vector<char> EventLoop<P>::met(const FoundIsland& island,
                                    const std::vector<ConeBody>& before) const {
  std::vector<char> met(island.members.size(), 0);
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    if (c.b == kWall || !island.near[k].touches) continue;
    const auto a = static_cast<std::size_t>(c.a);
    const auto b = static_cast<std::size_t>(c.b);
    if (dot(c.normal, before[a].velocity - island.bodies[b].velocity) > 0) met[a] = 1;
    if (dot(c.normal, island.bodies[a].velocity - before[b].velocity) > 0) met[b] = 1;
  }
  return met;
}

template <class P>
void EventLoop<P>::step_island(FoundIsland& island, At now) {
  ++counts_.steps;
  const std::size_t n = island.members.size();
  const Vec<double> g = in_double(motion_.law().pull());
  const double span =
      motion_.stepped_way(motion_.rules().scale.seconds(P::Clock::span(1, motion_.step_shift())));
  const auto speed = static_cast<double>(motion_.speed_of_step());
  const double still = (motion_.elastic() ? kStill * kStill : kStill) * speed;
  const std::vector<ConeBody> before = island.bodies;
  const double had = energy_of(island, 0).all();
  std::vector<ConeContact> lasting;
  std::vector<std::size_t> number;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (!lasts(island, k)) continue;
    lasting.push_back(island.contacts[k]);
    number.push_back(k);
  }
  for (ConeBody& body : island.bodies) body.velocity = body.velocity + span * g;
  ConeIsland whole(island.bodies, lasting);
  const double goal = (motion_.elastic() ? kSolved * kSolved : kSolved) * speed;
  const std::vector<double> pushes = whole.resolve(island.bodies, 1 / span, goal, true);
  std::vector<double> loads(island.contacts.size(), 0);
  for (std::size_t k = 0; k < number.size(); ++k) loads[number[k]] = pushes[k];

  DisjointSets sets;
  sets.reset(n);
  const auto find = [&sets](std::size_t k) { return sets.find(static_cast<std::uint32_t>(k)); };
  std::vector<int> loaded(n, 0);
  std::vector<char> on_balls(n, 0);
  std::vector<char> approaches(n, 0);
  std::vector<char> carries(island.contacts.size(), 0);
  for (const std::size_t k : number) {
    const ConeContact& c = island.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    const auto b = c.b == kWall ? a : static_cast<std::size_t>(c.b);
    const double mobility =
        island.bodies[a].inverse_mass + (c.b == kWall ? 0 : island.bodies[b].inverse_mass);
    const Vec<double> other = c.b == kWall ? Vec<double>{0, 0} : before[b].velocity;
    if (dot(c.normal, other - before[a].velocity) < -still) approaches[a] = approaches[b] = 1;
    if (!(loads[k] * mobility > kLoaded * speed)) continue;
    carries[k] = 1;
    ++loaded[a];
    const bool wall = c.b == kWall && island.near[k].partner >= kFirstMark;
    if (!wall) on_balls[a] = 1;
    if (c.b == kWall) continue;
    ++loaded[b];
    on_balls[b] = 1;
    sets.merge(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
  }
  std::vector<char> moves(n, 0);  // by the number of a set
  for (std::size_t m = 0; m < n; ++m) {
    const ConeBody& body = island.bodies[m];
    // A ball that rests already is not woken by what has not been solved to the end.
    const double most = island.support[m] == kResting ? 4 * still : still;
    if (std::abs(body.velocity.x) > most || std::abs(body.velocity.y) > most ||
        std::abs(body.turning) > most || loaded[m] == 0) {
      moves[find(m)] = 1;
    }
  }
  // On a single fixed ball it rests only straight above it.
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    if (carries[k] == 0 || c.b != kWall || island.near[k].partner >= kFirstMark) continue;
    const Vec<double> r = in_double(island.near[k].r);
    const double off = std::abs(cross(r, g));
    if (loaded[a] == 1 && off > 0x1p-40 * std::abs(dot(r, g))) moves[find(a)] = 1;
  }
  hold_still(island, sets, carries, moves);
  // Where energy is lost, what comes nearer to what rests, or leaves, would hit the island at once.
  if (!motion_.elastic()) pass_on_motion(island, sets, moves);
  const std::vector<char> stay = motion_.elastic() ? std::vector<char>(n, 0) : met(island, before);
  std::vector<char> newly(n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    ConeBody& body = island.bodies[m];
    if (moves[find(m)] == 0) {
      newly[m] = island.support[m] != kResting ? 1 : 0;
      island.support[m] = kResting;
      body.velocity = {0, 0};
      body.turning = 0;
    } else if (loaded[m] == 0 && approaches[m] == 0 && stay[m] == 0) {
      island.support[m] = 0;
      body = before[m];
    } else {
      island.support[m] = kStepped;
    }
  }
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    if (carries[k] == 0) continue;
    if (newly[a] != 0 || (c.b != kWall && newly[static_cast<std::size_t>(c.b)] != 0)) {
      ++counts_.resting_contacts;
    }
    const Index wall = island.near[k].partner;
    if (c.b != kWall || wall < kFirstMark || !island.near[k].touches) continue;
    if (motion_.elastic() && c.gap > 0) continue;
    const bool x = wall - kWalls < 2;
    const Disk& disk = disks_[island.members[a]];
    put_at(island, island.places[a], x ? 0 : 1, motion_.wall(disk, island.places[a], wall).stop,
           motion_.species(disk).inverse_mass);
    // Only walls carry it: it slides on, or rolls, if it does not come to rest.
    if (on_balls[a] != 0 || approaches[a] != 0 || stay[a] != 0) continue;
    const bool rests = island.support[a] == kResting && !motion_.elastic();
    if (island.support[a] != 0 && !rests) island.bodies[a] = before[a];
    (x ? island.bodies[a].velocity.x : island.bodies[a].velocity.y) = 0;
    island.support[a] = 0;
  }
  if (keep_energy(island, had, span)) keep_gaps(island, had, span, goal, loads);
  const double lost = loss_of(island, had, span);
  note_held(island, lost);
  const std::size_t first_line = notes_.lines();
  if (notes_.wanted()) {
    IslandCarried log;
    log.counted.resize(loads.size(), 0);
    log.impulses = loads;
    log.lost = lost;
    writer_.island(island, log, now);
  }
  book_.correct(lost);
  notes_.tell_loss(first_line, fly_on(island, now));
}

}  // namespace carom::event
