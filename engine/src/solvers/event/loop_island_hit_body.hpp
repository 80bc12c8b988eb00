#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/cone_island.hpp"
#include "contact/joint_impact.hpp"
#include "contact/rest_rules.hpp"
#include "solvers/event/loop_island_search_body.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

template <class P>
bool EventLoop<P>::is_hit_of_island(Index i, Index partner, At now) const {
  if (motion_.in_island(disks_[i])) return true;
  if (partner >= kFirstMark) return false;
  const Disk& other = disks_[partner];
  if (!motion_.fixed(other) && motion_.in_island(other)) return true;
  const Vec<S> r = motion_.way(motion_.place(disks_[i], now), motion_.place(other, now));
  return motion_.sticks(disks_[i], other, r, now);
}

// Balls that meet something at one instant; those of one island are resolved together. All are
// gathered before any is resolved.
template <class P>
void EventLoop<P>::hit_islands(std::vector<std::vector<Index>> hits, At now) {
  if (hits.empty()) return;
  const Stopwatch stopwatch(true, costs_.island_seconds());
  const auto gathered = [&](const std::vector<Index>& members) {
    FoundIsland island;
    for (const Index m : members) {
      if (number_[m] < 0) join(island, m, now);
    }
    schedule_step(now);
    gather(island, now, true);
    return island;
  };
  // Those that touch become one island, though none of them is of one yet.
  const auto mark = [&](char joins) {
    for (const auto& members : hits) {
      for (const Index m : members) joins_[m] = joins;
    }
  };
  mark(1);
  std::vector<FoundIsland> islands;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    // A ball that an earlier island has brings its island with it.
    for (bool more = true; more;) {
      FoundIsland island = gathered(hits[k]);
      more = false;
      for (std::size_t other = 0; other < islands.size(); ++other) {
        const std::vector<Index>& others = islands[other].members;
        const bool shares = std::any_of(others.begin(), others.end(), [&](Index m) {
          return std::find(island.members.begin(), island.members.end(), m) != island.members.end();
        });
        if (!shares) continue;
        hits[k].insert(hits[k].end(), others.begin(), others.end());
        islands.erase(islands.begin() + static_cast<std::ptrdiff_t>(other));
        more = true;
        break;
      }
      if (!more) islands.push_back(std::move(island));
    }
  }
  mark(0);
  for (FoundIsland& island : islands) {
    resolutions_.begin();
    hit_island(island, now);
    resolutions_.end();
  }
}

template <class P>
bool EventLoop<P>::lasts(const FoundIsland& island, std::size_t contact) const {
  if (!motion_.elastic()) return true;
  const ConeContact& c = island.contacts[contact];
  const auto& near = island.near[contact];
  const double speed = approach(island, contact);
  if (c.b == kWall && near.partner >= kFirstMark) {
    return island.touches[contact] != 0 &&
           speed <= static_cast<double>(motion_.lasting_speed(S(0), S(1)));
  }
  Vec<double> v = island.bodies[static_cast<std::size_t>(c.a)].velocity;
  if (c.b != kWall) v = v - island.bodies[static_cast<std::size_t>(c.b)].velocity;
  const S reach = root(S(dot(near.r, near.r)));
  const S most = motion_.lasting_speed(S(cross(c.normal, v)), reach);
  return speed <= static_cast<double>(most) &&
         c.gap <= static_cast<double>(S(most * motion_.seconds_of_step()));
}

// What meets now, and who stays.
template <class P>
auto EventLoop<P>::hits_of(const FoundIsland& island, At now) const -> Hits {
  Hits hits;
  hits.stays.resize(island.members.size(), 0);
  hits.counted.resize(island.contacts.size(), 0);
  hits.parts.resize(island.contacts.size(), 0);
  const auto disk_of = [&](int body) -> const Disk& {
    return disks_[island.members[static_cast<std::size_t>(body)]];
  };
  const auto speed_of_step = static_cast<double>(motion_.speed_of_step());
  hits.fastest = speed_of_step;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const auto& near = island.near[k];
    if (island.touches[k] == 0 && !near.comes) continue;
    const auto a = static_cast<std::size_t>(c.a);
    const double speed = approach(island, k);
    if (speed < -kStill * speed_of_step) continue;
    hits.fastest = std::max(hits.fastest, speed);
    const bool wall = near.partner >= kFirstMark && c.b == kWall;
    if (wall && island.support[a] < kResting && !(speed > 0)) continue;
    bool sticks = false;
    if (wall) {
      sticks = island.support[a] >= kResting && motion_.sticks_to_wall(disk_of(c.a), S(speed), now);
    } else {
      const Disk& partner = c.b == kWall ? disks_[near.partner] : disk_of(c.b);
      sticks = motion_.sticks(disk_of(c.a), partner, near.r, now);
    }
    if (speed > 0) {
      ++(wall ? hits.walls : hits.balls);
      hits.counted[k] = 1;
    }
    if (sticks) {
      hits.stays[a] = 1;
      if (c.b != kWall) hits.stays[static_cast<std::size_t>(c.b)] = 1;
    } else if (speed > 0) {
      hits.bounces = true;
      hits.parts[k] = 1;
      hits.restitution = std::min(
          hits.restitution, wall ? motion_.rules().wall_restitution : motion_.rules().restitution);
    }
  }
  return hits;
}

// A hit of an island whose contacts lose nothing along their normals is a joint impact of all that
// touches; who is pressed on afterwards, and has no speed along the normal, stays.
template <class P>
void EventLoop<P>::reflect_island(FoundIsland& island, Hits& hits) {
  std::vector<Body<double>> bodies;
  for (const ConeBody& body : island.bodies) bodies.push_back({body.velocity, body.inverse_mass});
  std::vector<Contact<double>> contacts;
  std::vector<std::size_t> number;
  const double restitution = gives_up() ? 0 : 1;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    if (island.touches[k] == 0) continue;
    if (c.b != kWall) {
      contacts.push_back({c.a, c.b, in_double(island.near[k].r), restitution});
    } else if (island.near[k].partner >= kFirstMark) {
      contacts.push_back({c.a, kWall, c.normal, restitution});
    } else {
      contacts.push_back(
          {c.a, static_cast<int>(bodies.size()), in_double(island.near[k].r), restitution});
      bodies.push_back({{0, 0}, 0});
    }
    number.push_back(k);
  }
  if (hits.walls + hits.balls > 0) {
    const JointReport report = joint_impact<double>(bodies, contacts);
    counts_.jammed += gives_up() ? contacts.size() : static_cast<std::uint64_t>(report.jammed);
    hits.held = report.held_energy;
    for (std::size_t m = 0; m < island.bodies.size(); ++m) {
      island.bodies[m].velocity = bodies[m].velocity;
    }
  }
  std::fill(hits.stays.begin(), hits.stays.end(), 0);
  for (const std::size_t k : number) {
    const ConeContact& c = island.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    const bool wall = c.b == kWall && island.near[k].partner >= kFirstMark;
    if (wall) continue;
    // Two that fall press each other only where something holds one of them.
    const Disk& disk = disks_[island.members[a]];
    const double pressing =
        c.b == kWall ? dot(c.normal, in_double(motion_.law_of(disk).pull())) : 0;
    const double away = gives_up() ? 0 : std::abs(approach(island, k));
    const auto reach = static_cast<double>(root(S(dot(island.near[k].r, island.near[k].r))));
    const auto pull = static_cast<double>(motion_.pull());
    if (!barely_bounces(away, c.b == kWall ? pressing : pull, reach, kAtOnce) && away != 0)
      continue;
    if (c.b == kWall && !(pressing > 0) && !gives_up()) continue;
    hits.stays[a] = 1;
    if (c.b != kWall) hits.stays[static_cast<std::size_t>(c.b)] = 1;
  }
}

// What meets a wall is exactly there, and does not go into it; where energy is kept, what is still
// a little above it stays there.
template <class P>
void EventLoop<P>::put_on_walls(FoundIsland& island) const {
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    const Index wall = island.near[k].partner;
    if (c.b != kWall || wall < kFirstMark || island.touches[k] == 0) continue;
    if (motion_.elastic() && c.gap > 0) continue;
    const Disk& disk = disks_[island.members[a]];
    const std::size_t axis = (wall - kWalls) / 2;
    put_at(island, island.places[a], axis, motion_.wall(disk, island.places[a], wall).stop,
           motion_.species(disk).inverse_mass);
    stop_at(island.bodies[a], c);
  }
}

template <class P>
void EventLoop<P>::hit_island(FoundIsland& island, At now) {
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (island.touches[k] == 0) continue;
    const int b = island.contacts[k].b;
    const Index other =
        b == kWall ? island.near[k].partner : island.members[static_cast<std::size_t>(b)];
    pairs_.note_resolved(island.members[static_cast<std::size_t>(island.contacts[k].a)], other);
  }
  schedule_step(now);
  double span = 0;  // until the next step; 0: for ever
  if (step_clock_.runs()) {
    span = motion_.stepped_way(motion_.rules().scale.seconds(step_clock_.next() - now));
  }
  Hits hits = hits_of(island, now);
  counts_.ball_wall += hits.walls;
  counts_.ball_ball += hits.balls;
  if (hits.walls + hits.balls > 1) ++counts_.joint_impacts;

  const double had = island_energy_.of(island, span).all();
  const bool elastic = motion_.elastic();
  // What a joint impact has left is only what gravity makes until the next step.
  const double goal = elastic ? std::max(kSolved * static_cast<double>(motion_.speed_of_step()),
                                         kSolved * kSolved * hits.fastest) *
                                    kSolved
                              : kSolved * hits.fastest;
  IslandCarried log;
  const Vec<double> g = in_double(motion_.law().pull());
  if (elastic) {
    reflect_island(island, hits);
  } else if (hits.bounces) {
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      if (hits.parts[k] != 0) island.contacts[k].parting = hits.restitution * approach(island, k);
    }
  }
  bool rested = false;
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    unsigned& support = island.support[m];
    rested = rested || support == kResting;
    if (support == kResting && notes_.wanted()) writer_.wake(island.members[m], now);
    const bool of_it = (support >= kResting && (!elastic || gives_up())) || hits.stays[m] != 0;
    if (of_it && support != kStepped) {
      // It has not been given what gravity makes till the next step.
      island.bodies[m].velocity = island.bodies[m].velocity + span * g;
    }
    support = of_it ? kStepped : 0;
  }
  if (rested) ++counts_.wakes;
  std::vector<double> loads(island.contacts.size(), 0);
  hold_on(island, span, goal, loads);
  put_on_walls(island);
  for (ConeContact& contact : island.contacts) contact.parting = 0;
  const double kept = had - 2 * hits.held;
  if (island_energy_.keep(island, kept, span, gives_up())) {
    if (motion_.keeps_energy()) {
      keep_gaps(island, kept, span, goal, loads);
    } else {
      hold_on(island, span, goal, loads);
      put_on_walls(island);
    }
  }
  const double lost = island_energy_.loss(island, had, span);
  if (!(hits.held > 0) && island_energy_.is_held(island, lost)) ++counts_.jammed;
  const std::size_t first_line = notes_.lines();
  if (notes_.wanted()) {
    log.counted = hits.counted;
    log.impulses = loads;
    log.lost = lost;
    writer_.island(island, log, now);
  }

  book_.correct(lost);
  notes_.tell_loss(first_line, fly_on(island, now));
}

template <class P>
bool EventLoop<P>::holds(const FoundIsland& island, std::size_t contact) const {
  const auto steps = [&](int body) {
    return body == kWall || island.support[static_cast<std::size_t>(body)] == kStepped;
  };
  const ConeContact& c = island.contacts[contact];
  return steps(c.a) && steps(c.b) && lasts(island, contact);
}

// Impulses by which nothing closes before the next step; where impacts are elastic, only among
// those that stay, as others meet at their own time.
template <class P>
void EventLoop<P>::press(FoundIsland& island, double span, double goal,
                         std::vector<double>& loads) const {
  std::vector<ConeContact> contacts;
  std::vector<std::size_t> number;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    if (motion_.elastic() && !holds(island, k)) continue;
    contacts.push_back(c);
    number.push_back(k);
  }
  const double rate = span > 0 ? 1 / span : 0;
  ConeIsland whole(island.bodies, contacts);
  const std::vector<double> impulses = whole.resolve(island.bodies, rate, goal);
  for (std::size_t k = 0; k < number.size(); ++k) loads[number[k]] += impulses[k];
}

// What goes faster, so that energy is kept, may close a contact beyond touching: then that one is
// held again, and what it loses goes to the others.
template <class P>
void EventLoop<P>::keep_gaps(FoundIsland& island, double had, double span, double goal,
                             std::vector<double>& loads) const {
  if (!motion_.keeps_energy() || gives_up() || !(span > 0)) return;
  const double touching = kTouching * motion_.largest_radius();
  const auto closes = [&] {
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      const double way = approach(island, k) * span;
      const double gap = std::max(island.contacts[k].gap, 0.0);
      if (way > gap + touching && holds(island, k)) return true;
    }
    return false;
  };
  for (int round = 0; round < kMostTurns && closes(); ++round) {
    press(island, span, goal, loads);
    island_energy_.keep(island, had, span, gives_up());
  }
}

// What leaves an island, and still comes nearer to what it touches, stays.
template <class P>
void EventLoop<P>::hold_on(FoundIsland& island, double span, double goal,
                           std::vector<double>& loads) const {
  const Vec<double> g = in_double(motion_.law().pull());
  for (bool more = true; more;) {
    press(island, span, goal, loads);
    more = false;
    for (std::size_t k = 0; k < island.contacts.size() && !motion_.elastic(); ++k) {
      const ConeContact& c = island.contacts[k];
      const bool wall = c.b == kWall && island.near[k].partner >= kFirstMark;
      if (wall || island.touches[k] == 0 || !(approach(island, k) > 0)) continue;
      for (const int body : {c.a, c.b}) {
        if (body == kWall) continue;
        unsigned& support = island.support[static_cast<std::size_t>(body)];
        if (support == kStepped) continue;
        support = kStepped;
        Vec<double>& v = island.bodies[static_cast<std::size_t>(body)].velocity;
        v = v + span * g;
        more = true;
      }
    }
  }
}

}  // namespace carom::event
