#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "contact/crowd.hpp"
#include "contact/rest_rules.hpp"
#include "numbers/exact_sum.hpp"
#include "solvers/event/tile.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

/// The balls of one crowd, those that come to it, and their near contacts, at one instant.
template <class P>
struct Tile<P>::Gathering {
  /// A near contact, beside what its impulse depends on.
  struct Near {
    Vec<S> r;                  ///< between balls: from the first centre to the second
    Index partner = kUnknown;  ///< what it is with, where that never moves: a wall or a ball
    bool touches = false;
  };

  std::vector<Index> members;
  std::vector<Vec<S>> places;
  std::vector<unsigned> carried;
  std::vector<CrowdBody> bodies;
  std::vector<CrowdContact> contacts;
  std::vector<Near> near;  ///< by contact
};

template <class P>
void Tile<P>::join(Gathering& crowd, Index i, At now) requires kCanRest {
  Disk& disk = disks_[i];
  number_[i] = static_cast<int>(crowd.members.size());
  crowd.members.push_back(i);
  crowd.carried.push_back(motion_.carried(disk));
  Vec<S> at = motion_.wrapped(motion_.place(disk, now));
  const auto& kind = motion_.kind(disk);
  S turning = 0;
  if (!spins_.empty()) turning = kind.radius * spins_[i];
  crowd.bodies.push_back({motion_.velocity(disk, now), turning, kind.inverse_mass});
  for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
    const std::size_t axis = (wall - kWalls) / 2;
    if (!motion_.rules().domain.solid(axis)) continue;
    const auto [gap, stop] = motion_.wall(disk, at, wall);
    if (gap > 2 * kind.radius * kNear) continue;
    S& x = axis == 0 ? at.x : at.y;
    if (gap < 0) x = stop;
    const S side = wall % 2 == kWalls % 2 ? -1 : 1;
    const Vec<S> towards = axis == 0 ? Vec<S>{side, S(0)} : Vec<S>{S(0), side};
    const bool touches = !(gap > 2 * kind.radius * kTouching);
    crowd.contacts.push_back(
        {number_[i], kWall, towards, larger(gap, S(0)), S(motion_.rules().wall_friction)});
    crowd.near.push_back({towards, wall, touches});
  }
  crowd.places.push_back(at);
}

// Whoever can be reached from the members over near contacts of balls that are of a crowd.
template <class P>
void Tile<P>::gather(Gathering& crowd, At now) requires kCanRest {
  if (!motion_.rules().collisions) return;
  const S friction = motion_.rules().friction;
  std::vector<Index> around;
  for (std::size_t m = 0; m < crowd.members.size(); ++m) {
    const Index i = crowd.members[m];
    const Vec<S> here = crowd.places[m];
    const S radius = motion_.kind(disks_[i]).radius;
    const auto found = neighbours_.around(static_cast<double>(here.x), static_cast<double>(here.y));
    around.assign(found.begin(), found.end());
    std::sort(around.begin(), around.end());
    for (const Index j : around) {
      if (j == i) continue;
      const bool fixed = motion_.fixed(disks_[j]);
      if (number_[j] < 0 && !fixed && !motion_.crowded(disks_[j])) continue;
      const S reach = radius + motion_.kind(disks_[j]).radius;
      const Vec<S> there = number_[j] >= 0 ? crowd.places[static_cast<std::size_t>(number_[j])]
                                           : motion_.wrapped(motion_.place(disks_[j], now));
      const Vec<S> r = motion_.way(here, there);
      if (!near(r, reach, S(kNear))) continue;
      if (number_[j] < 0 && !fixed) join(crowd, j, now);
      if (!fixed && number_[j] > number_[i]) continue;  // it is found from there, too
      const S length = root(S(r.x * r.x + r.y * r.y));
      const S gap = squared_gap(r, reach) / (length + reach);
      crowd.contacts.push_back(
          {number_[i], fixed ? kWall : number_[j], (1 / length) * r, gap, friction});
      crowd.near.push_back({r, fixed ? j : kUnknown, near(r, reach, S(kTouching))});
      const S depth = -gap / std::min(radius, motion_.kind(disks_[j]).radius);
      counts_.max_overlap = std::max(counts_.max_overlap, static_cast<double>(depth));
    }
  }
}

// Every member begins the flight that `crowd` says, as what `carried` says.
template <class P>
void Tile<P>::fly_on(Gathering& crowd, At now) requires kCanRest {
  bool moves = false;
  for (std::size_t m = 0; m < crowd.members.size(); ++m) {
    const Index i = crowd.members[m];
    number_[i] = -1;
    unlink(i);
    forget(i);
    Disk& disk = disks_[i];
    disk.x = crowd.places[m].x;
    disk.y = crowd.places[m].y;
    disk.vx = crowd.bodies[m].velocity.x;
    disk.vy = crowd.bodies[m].velocity.y;
    if (!spins_.empty()) spins_[i] = crowd.bodies[m].turning / motion_.kind(disk).radius;
    disk.start = now;
    motion_.set_carried(disk, crowd.carried[m]);
    left_[i] = kUnknown;
    moves = moves || crowd.carried[m] == kStepped;
  }
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const auto a = static_cast<std::size_t>(crowd.contacts[k].a);
    const Index i = crowd.members[a];
    const Index partner = crowd.near[k].partner;
    if (crowd.carried[a] < kResting && crowd.near[k].touches && partner < kFirstMark) {
      left_[i] = partner;
    }
  }
  if (moves) schedule_step(now);
  for (std::size_t m = 0; m < crowd.members.size(); ++m) {
    if (crowd.carried[m] < kResting) lean(crowd.members[m]);
  }
  book_.keep();
  for (const Index i : crowd.members) look_again(i, now);
}

// Whether this impact is one of a crowd; then it is done.
template <class P>
bool Tile<P>::hit_crowd(Index i, Index partner, At now) requires kCanRest {
  const bool ball = partner < kFirstMark;
  const bool moving = ball && !motion_.fixed(disks_[partner]);
  if (!motion_.crowded(disks_[i]) && !(moving && motion_.crowded(disks_[partner]))) {
    if (!ball) return false;
    const Vec<S> r =
        motion_.way(motion_.place(disks_[i], now), motion_.place(disks_[partner], now));
    if (!motion_.clings(disks_[i], disks_[partner], r, now)) return false;
  }
  Gathering crowd;
  join(crowd, i, now);
  if (moving) join(crowd, partner, now);
  hit_crowd(crowd, now);
  return true;
}

template <class P>
void Tile<P>::hit_crowd(Gathering& crowd, At now) requires kCanRest {
  const Stopwatch stopwatch(true, crowd_seconds_);
  gather(crowd, now);
  schedule_step(now);
  S span = 0;  // until the next step; 0: for ever
  if (next_step_ != P::Clock::never()) span = motion_.rules().scale.seconds(next_step_ - now);
  const S rate = span > 0 ? S(1 / span) : S(0);
  const auto disk_of = [&](int body) -> const Disk& {
    return disks_[crowd.members[static_cast<std::size_t>(body)]];
  };
  // What meets now: with what restitution, and who stays.
  S restitution = 1;
  S fastest = motion_.speed_of_step();
  bool bounces = false;
  std::vector<char> stays(crowd.members.size(), 0);
  std::uint64_t walls = 0;
  std::uint64_t balls = 0;
  CrowdLog log;
  if (log_ != nullptr) log.counted.resize(crowd.contacts.size(), 0);
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const CrowdContact& c = crowd.contacts[k];
    const typename Gathering::Near& near = crowd.near[k];
    if (!near.touches) continue;
    const auto a = static_cast<std::size_t>(c.a);
    const Vec<S>& v = crowd.bodies[a].velocity;
    const Vec<S> other =
        c.b == kWall ? Vec<S>{S(0), S(0)} : crowd.bodies[static_cast<std::size_t>(c.b)].velocity;
    const S speed = -sharp_dot(c.normal, other - v);
    if (speed < -kStill * motion_.speed_of_step()) continue;
    fastest = larger(fastest, speed);
    const bool wall = near.partner >= kFirstMark && c.b == kWall;
    if (wall && crowd.carried[a] < kResting && !(speed > 0)) continue;
    bool clings = false;
    if (wall) {
      clings = crowd.carried[a] >= kResting && motion_.clings_to_wall(disk_of(c.a), speed, now);
    } else {
      const Disk& partner = c.b == kWall ? disks_[near.partner] : disk_of(c.b);
      clings = motion_.clings(disk_of(c.a), partner, near.r, now);
    }
    if (speed > 0) ++(wall ? walls : balls);
    if (log_ != nullptr && speed > 0) log.counted[k] = 1;
    if (clings) {
      stays[a] = 1;
      if (c.b != kWall) stays[static_cast<std::size_t>(c.b)] = 1;
    } else if (speed > 0) {
      bounces = true;
      restitution = std::min(
          restitution, wall ? S(motion_.rules().wall_restitution) : S(motion_.rules().restitution));
    }
  }
  counts_.ball_wall += walls;
  counts_.ball_ball += balls;
  if (walls + balls > 1) ++counts_.joint_impacts;

  const S had = energy_of(crowd, span).all();
  Crowd whole(crowd.bodies, crowd.contacts);
  const S goal = kSolved * fastest;
  if (bounces && restitution > 0) {
    const std::vector<CrowdBody> before = crowd.bodies;
    log.impulses = whole.resolve(crowd.bodies, rate, goal);
    const auto beyond = [&](const S& was, const S& is) { return S(is + restitution * (is - was)); };
    for (std::size_t m = 0; m < crowd.bodies.size(); ++m) {
      CrowdBody& body = crowd.bodies[m];
      const CrowdBody& was = before[m];
      body.velocity = {beyond(was.velocity.x, body.velocity.x),
                       beyond(was.velocity.y, body.velocity.y)};
      body.turning = beyond(was.turning, body.turning);
    }
  }
  bool rested = false;
  for (std::size_t m = 0; m < crowd.members.size(); ++m) {
    unsigned& carried = crowd.carried[m];
    rested = rested || carried == kResting;
    const bool of_it = carried >= kResting || stays[m] != 0;
    if (of_it && carried != kStepped) {
      // It has not been given what gravity makes till the next step.
      crowd.bodies[m].velocity = crowd.bodies[m].velocity + span * motion_.law().pull();
    }
    carried = of_it ? kStepped : 0;
  }
  if (rested) ++counts_.wakes;
  const std::vector<double> loads = whole.resolve(crowd.bodies, rate, goal);
  slow_down(crowd, had, span);
  if (log_ != nullptr) {
    log.impulses.resize(loads.size(), 0);
    for (std::size_t k = 0; k < loads.size(); ++k) {
      log.impulses[k] = (1 + static_cast<double>(restitution)) * log.impulses[k] + loads[k];
    }
    log.lost = static_cast<double>(S(had - energy_of(crowd, span).all())) / 2;
    log_crowd(crowd, log, now);
  }

  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const auto a = static_cast<std::size_t>(crowd.contacts[k].a);
    const Index wall = crowd.near[k].partner;
    if (crowd.contacts[k].b != kWall || wall < kFirstMark || !crowd.near[k].touches) continue;
    // What meets a wall is exactly there.
    const bool x = wall - kWalls < 2;
    S& at = x ? crowd.places[a].x : crowd.places[a].y;
    at = motion_.wall(disks_[crowd.members[a]], crowd.places[a], wall).stop;
    S& v = x ? crowd.bodies[a].velocity.x : crowd.bodies[a].velocity.y;
    if ((x ? crowd.contacts[k].normal.x : crowd.contacts[k].normal.y) * v > 0) v = 0;
  }
  note_loss(crowd, had, span);
  fly_on(crowd, now);
}

template <class P>
void Tile<P>::step_crowds(At now) requires kCanRest {
  const Stopwatch stopwatch(true, crowd_seconds_);
  std::vector<Index> all;
  for (Index i = 0; i < disks_.size(); ++i) {
    if (!motion_.fixed(disks_[i]) && motion_.carried(disks_[i]) >= kStepped) all.push_back(i);
  }
  std::vector<char> stepped(disks_.size(), 0);
  for (const Index i : all) {
    if (stepped[i] != 0) continue;
    Gathering crowd;
    join(crowd, i, now);
    gather(crowd, now);
    for (const Index m : crowd.members) stepped[m] = 1;
    step_crowd(crowd, now);
  }
}

// Twice what the energy of a crowd is but for its height: what moves, less what gravity has given
// ahead to those that are stepped, for the time of `span`.
template <class P>
auto Tile<P>::energy_of(const Gathering& crowd, const S& span) const
    -> CrowdEnergy requires kCanRest {
  const Vec<S>& g = motion_.law().pull();
  ExactSum<S> stepped;
  ExactSum<S> ahead;
  ExactSum<S> others;
  for (std::size_t m = 0; m < crowd.bodies.size(); ++m) {
    const CrowdBody& body = crowd.bodies[m];
    const S mass = 1 / body.inverse_mass;
    const bool steps = crowd.carried[m] == kStepped;
    ExactSum<S>& moving = steps ? stepped : others;
    moving.add(mass * (body.velocity.x * body.velocity.x));
    moving.add(mass * (body.velocity.y * body.velocity.y));
    moving.add(mass / 2 * (body.turning * body.turning));
    if (!steps) continue;
    ahead.add(2 * span * mass * (g.x * body.velocity.x));
    ahead.add(2 * span * mass * (g.y * body.velocity.y));
  }
  return {stepped.rounded(), ahead.rounded(), others.rounded()};
}

// What is left unsolved must not make energy: those that are stepped are slowed down to what there
// was.
template <class P>
void Tile<P>::slow_down(Gathering& crowd, const S& had, const S& span) const requires kCanRest {
  const CrowdEnergy now = energy_of(crowd, span);
  if (!(now.all() > had) || !(now.stepped > 0)) return;
  // stepped a^2 - ahead a + others <= had, for the largest a
  const S half = now.ahead / 2;
  const S square = half * half + now.stepped * (had - now.others);
  const S a = square > 0 ? larger(S((half + root(square)) / now.stepped), S(0)) : S(0);
  if (!(a < 1)) return;
  for (std::size_t m = 0; m < crowd.bodies.size(); ++m) {
    if (crowd.carried[m] != kStepped) continue;
    CrowdBody& body = crowd.bodies[m];
    body.velocity = a * body.velocity;
    body.turning = a * body.turning;
  }
}

// The contacts of a crowd only take: what they have taken is what it has less.
template <class P>
void Tile<P>::note_loss(const Gathering& crowd, const S& had, const S& span) requires kCanRest {
  book_.note(static_cast<double>(S(had - energy_of(crowd, span).all())) / 2);
}

template <class P>
double Tile<P>::given_ahead(At now) const requires kCanRest {
  double sum = 0;
  if (next_step_ == P::Clock::never()) return sum;
  const S span = motion_.rules().scale.seconds(next_step_ - now);
  const Vec<S>& g = motion_.law().pull();
  for (const Disk& disk : disks_) {
    if (motion_.fixed(disk) || motion_.carried(disk) != kStepped) continue;
    sum += static_cast<double>(
        S(span * (g.x * disk.vx + g.y * disk.vy) / motion_.kind(disk).inverse_mass));
  }
  return sum;
}

// What is slow comes to rest only where forces at its contacts hold it: what is pulled moves on. Of
// many balls, which creep until all contacts carry, slowness decides.
template <class P>
void Tile<P>::hold_still(const Gathering& crowd, std::vector<std::size_t>& set,
                         const std::vector<char>& carries,
                         std::vector<char>& moves) const requires kCanRest {
  const std::size_t n = crowd.members.size();
  const auto find = [&set](std::size_t k) {
    while (set[k] != k) k = set[k] = set[set[k]];
    return k;
  };
  const auto span = static_cast<double>(
      S(motion_.rules().scale.seconds(P::Clock::span(1, motion_.step_shift()))));
  const auto speed = static_cast<double>(motion_.speed_of_step());
  const Vec<double> g = motion_.law().pull();
  for (std::size_t first = 0; first < n; ++first) {
    if (find(first) != first || moves[first] != 0) continue;
    std::vector<int> number(n, -1);
    std::vector<CrowdBody> bodies;
    bool fresh = false;
    for (std::size_t m = 0; m < n; ++m) {
      if (find(m) != first) continue;
      number[m] = static_cast<int>(bodies.size());
      bodies.push_back({span * g, 0, crowd.bodies[m].inverse_mass});
      fresh = fresh || crowd.carried[m] != kResting;
    }
    if (!fresh || bodies.size() > kFewHeld) continue;
    std::vector<CrowdContact> contacts;
    for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
      CrowdContact contact = crowd.contacts[k];
      const int a = number[static_cast<std::size_t>(contact.a)];
      if (a < 0 || (carries[k] == 0 && !crowd.near[k].touches)) continue;
      contact.a = a;
      if (contact.b != kWall) contact.b = number[static_cast<std::size_t>(contact.b)];
      if (crowd.contacts[k].b != kWall && contact.b < 0) continue;
      contact.gap = 0;
      contacts.push_back(contact);
    }
    Crowd whole(bodies, contacts);
    whole.resolve(bodies, 0, kHeld / 4 * speed);
    for (const CrowdBody& body : bodies) {
      const double most =
          std::max({std::abs(body.velocity.x), std::abs(body.velocity.y), std::abs(body.turning)});
      if (most > kHeld * speed) moves[first] = 1;
    }
  }
}

template <class P>
void Tile<P>::step_crowd(Gathering& crowd, At now) requires kCanRest {
  ++counts_.steps;
  const std::size_t n = crowd.members.size();
  const Vec<S>& g = motion_.law().pull();
  const S span = motion_.rules().scale.seconds(P::Clock::span(1, motion_.step_shift()));
  const S speed = motion_.speed_of_step();
  const S still = kStill * speed;
  const std::vector<CrowdBody> before = crowd.bodies;
  const S had = energy_of(crowd, S(0)).all();
  for (CrowdBody& body : crowd.bodies) body.velocity = body.velocity + span * g;
  Crowd whole(crowd.bodies, crowd.contacts);
  const std::vector<S> loads = whole.resolve(crowd.bodies, S(1 / span), S(kSolved * speed), true);

  std::vector<std::size_t> set(n);
  std::iota(set.begin(), set.end(), 0U);
  const auto find = [&set](std::size_t k) {
    while (set[k] != k) k = set[k] = set[set[k]];
    return k;
  };
  std::vector<int> loaded(n, 0);
  std::vector<char> on_balls(n, 0);
  std::vector<char> approaches(n, 0);
  std::vector<char> slips(n, 0);
  std::vector<char> carries(crowd.contacts.size(), 0);
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const CrowdContact& c = crowd.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    const auto b = c.b == kWall ? a : static_cast<std::size_t>(c.b);
    const S mobility =
        crowd.bodies[a].inverse_mass + (c.b == kWall ? S(0) : crowd.bodies[b].inverse_mass);
    const Vec<S> other = c.b == kWall ? Vec<S>{S(0), S(0)} : before[b].velocity;
    if (dot(c.normal, other - before[a].velocity) < -still) approaches[a] = approaches[b] = 1;
    if (!(loads[k] * mobility > kLoaded * speed)) continue;
    carries[k] = 1;
    ++loaded[a];
    const bool wall = c.b == kWall && crowd.near[k].partner >= kFirstMark;
    if (!wall) on_balls[a] = 1;
    if (wall && c.friction != 0) {
      const S slip =
          absolute(S(cross(c.normal, crowd.bodies[a].velocity) + crowd.bodies[a].turning));
      if (slip > still) slips[a] = 1;
    }
    if (c.b == kWall) continue;
    ++loaded[b];
    on_balls[b] = 1;
    set[find(a)] = find(b);
  }
  std::vector<char> restless(n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    const CrowdBody& body = crowd.bodies[m];
    // Who rests already is not woken by what has not been solved to the end.
    const S most = crowd.carried[m] == kResting ? S(4 * still) : still;
    if (absolute(body.velocity.x) > most || absolute(body.velocity.y) > most ||
        absolute(body.turning) > most || loaded[m] == 0) {
      restless[m] = 1;
    }
  }
  // On a single fixed ball it rests only straight above it.
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const CrowdContact& c = crowd.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    if (carries[k] == 0 || c.b != kWall || crowd.near[k].partner >= kFirstMark) continue;
    const S off = absolute(cross(crowd.near[k].r, g));
    if (loaded[a] == 1 && off > 0x1p-40 * absolute(dot(crowd.near[k].r, g))) restless[a] = 1;
  }
  std::vector<char> moves(n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    if (restless[m] != 0) moves[find(m)] = 1;
  }
  hold_still(crowd, set, carries, moves);
  std::vector<char> newly(n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    CrowdBody& body = crowd.bodies[m];
    if (moves[find(m)] == 0) {
      newly[m] = crowd.carried[m] != kResting ? 1 : 0;
      crowd.carried[m] = kResting;
      body.velocity = {S(0), S(0)};
      body.turning = 0;
    } else if (loaded[m] == 0 && approaches[m] == 0) {
      crowd.carried[m] = 0;
      body = before[m];
    } else {
      crowd.carried[m] = kStepped;
    }
  }
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const CrowdContact& c = crowd.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    if (carries[k] == 0) continue;
    if (newly[a] != 0 || (c.b != kWall && newly[static_cast<std::size_t>(c.b)] != 0)) {
      ++counts_.resting_contacts;
    }
    const Index wall = crowd.near[k].partner;
    if (c.b != kWall || wall < kFirstMark || !crowd.near[k].touches) continue;
    const bool x = wall - kWalls < 2;
    S& at = x ? crowd.places[a].x : crowd.places[a].y;
    at = motion_.wall(disks_[crowd.members[a]], crowd.places[a], wall).stop;
    // Only walls carry it: it glides on, or rolls.
    if (on_balls[a] != 0 || slips[a] != 0 || approaches[a] != 0) continue;
    // From here on gravity acts along the wall as it falls: what was given ahead is taken back.
    if (crowd.carried[a] == kStepped && c.friction == 0) {
      crowd.bodies[a].velocity = crowd.bodies[a].velocity - span * g;
    }
    (x ? crowd.bodies[a].velocity.x : crowd.bodies[a].velocity.y) = 0;
    crowd.carried[a] = 0;
  }
  slow_down(crowd, had, span);
  if (log_ != nullptr) {
    CrowdLog log;
    log.counted.resize(loads.size(), 0);
    for (const S& load : loads) log.impulses.push_back(static_cast<double>(load));
    log.lost = static_cast<double>(S(had - energy_of(crowd, span).all())) / 2;
    log_crowd(crowd, log, now);
  }
  note_loss(crowd, had, span);
  fly_on(crowd, now);
}

}  // namespace carom::event
