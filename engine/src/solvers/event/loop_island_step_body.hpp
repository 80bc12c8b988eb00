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
  const double had = island_energy_.of(island, 0).all();
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
  hold_still(island, {g, span, speed}, sets, carries, moves);
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
    if (c.b != kWall || wall < kFirstMark || island.touches[k] == 0) continue;
    if (motion_.elastic() && c.gap > 0) continue;
    const bool x = wall - kWalls < 2;
    const Disk& disk = disks_[island.members[a]];
    put_at(island, island.places[a], x ? 0 : 1, motion_.wall(disk, island.places[a], wall).stop,
           motion_.species(disk).inverse_mass);
    // It does not go into a wall that takes speed, not even by what has been left unsolved.
    const bool takes = motion_.rules().wall_restitution < 1;
    if (takes && island.support[a] == kStepped && approach(island, k) < 4 * goal) {
      stop_at(island.bodies[a], c);
    }
    // Only walls carry it: it slides on, or rolls, if it does not come to rest.
    if (on_balls[a] != 0 || approaches[a] != 0 || stay[a] != 0) continue;
    const bool rests = island.support[a] == kResting && !motion_.elastic();
    if (island.support[a] != 0 && !rests) island.bodies[a] = before[a];
    (x ? island.bodies[a].velocity.x : island.bodies[a].velocity.y) = 0;
    island.support[a] = 0;
  }
  if (island_energy_.keep(island, had, span, gives_up())) keep_gaps(island, had, span, goal, loads);
  const double lost = island_energy_.loss(island, had, span);
  if (island_energy_.is_held(island, lost)) ++counts_.jammed;
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
