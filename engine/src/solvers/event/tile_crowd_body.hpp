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
  double lifted = 0;       ///< the height that balls were given, in energy
};

// Moves a ball along an axis, onto a wall.
template <class P>
void Tile<P>::put_at(Gathering& crowd, Vec<S>& at, std::size_t axis, const S& stop,
                     const S& inverse_mass) const {
  S& x = axis == 0 ? at.x : at.y;
  crowd.lifted += static_cast<double>(S((x - stop) * motion_.law().pull(axis) / inverse_mass));
  x = stop;
}

template <class P>
void Tile<P>::join(Gathering& crowd, Index i, At now) {
  Disk& disk = disks_[i];
  number_[i] = static_cast<int>(crowd.members.size());
  crowd.members.push_back(i);
  crowd.carried.push_back(motion_.carried(disk));
  Vec<S> at = motion_.wrapped(motion_.place(disk, now));
  const auto& kind = motion_.kind(disk);
  S turning = 0;
  if (!spins_.empty()) turning = kind.radius * motion_.spin_at(disk, spins_[i], now);
  crowd.bodies.push_back({in_double(motion_.velocity(disk, now)), static_cast<double>(turning),
                          static_cast<double>(kind.inverse_mass)});
  for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
    const std::size_t axis = (wall - kWalls) / 2;
    if (!motion_.rules().domain.solid(axis)) continue;
    const auto [gap, stop] = motion_.wall(disk, at, wall);
    if (gap > 2 * kind.radius * kNear) continue;
    if (gap < 0) put_at(crowd, at, axis, stop, kind.inverse_mass);
    const S side = wall % 2 == kWalls % 2 ? -1 : 1;
    const Vec<S> towards = axis == 0 ? Vec<S>{side, S(0)} : Vec<S>{S(0), side};
    const bool touches = !(gap > 2 * kind.radius * kTouching);
    crowd.contacts.push_back({number_[i], kWall, in_double(towards),
                              static_cast<double>(larger(gap, S(0))),
                              motion_.rules().wall_friction});
    crowd.near.push_back({towards, wall, touches});
  }
  crowd.places.push_back(at);
}

// Whoever can be reached from the members over near contacts of balls that are of a crowd.
template <class P>
void Tile<P>::gather(Gathering& crowd, At now) {
  if (!motion_.rules().collisions) return;
  const double friction = motion_.rules().friction;
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
      crowd.contacts.push_back({number_[i], fixed ? kWall : number_[j],
                                in_double(S(1 / length) * r), static_cast<double>(gap), friction});
      crowd.near.push_back({r, fixed ? j : kUnknown, near(r, reach, S(kTouching))});
      const S depth = -gap / std::min(radius, motion_.kind(disks_[j]).radius);
      counts_.max_overlap = std::max(counts_.max_overlap, static_cast<double>(depth));
    }
  }
}

// Every member begins the flight that `crowd` says, as what `carried` says.
template <class P>
double Tile<P>::fly_on(Gathering& crowd, At now) {
  bool moves = false;
  for (std::size_t m = 0; m < crowd.members.size(); ++m) {
    const Index i = crowd.members[m];
    number_[i] = -1;
    remember(i);
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
  const double lost = book_.keep();
  for (const Index i : crowd.members) look_again(i, now);
  return lost;
}

template <class P>
bool Tile<P>::is_hit_of_crowd(Index i, Index partner, At now) const {
  if (motion_.crowded(disks_[i])) return true;
  if (partner >= kFirstMark) return false;
  const Disk& other = disks_[partner];
  if (!motion_.fixed(other) && motion_.crowded(other)) return true;
  const Vec<S> r = motion_.way(motion_.place(disks_[i], now), motion_.place(other, now));
  return motion_.clings(disks_[i], other, r, now);
}

// Whether this impact is one of a crowd; then it is done.
template <class P>
bool Tile<P>::hit_crowd(Index i, Index partner, At now) {
  if (!is_hit_of_crowd(i, partner, now)) return false;
  Gathering crowd;
  join(crowd, i, now);
  if (partner < kFirstMark && !motion_.fixed(disks_[partner])) join(crowd, partner, now);
  hit_crowd(crowd, now);
  return true;
}

// Balls that meet something at one instant; those of one crowd are resolved together.
template <class P>
void Tile<P>::hit_crowds(std::vector<std::vector<Index>> hits, At now) {
  if (hits.size() > 1) {
    std::vector<std::size_t> owner(disks_.size(), hits.size());
    for (std::size_t k = 0; k < hits.size(); ++k) {
      Gathering crowd;
      for (const Index m : hits[k]) join(crowd, m, now);
      gather(crowd, now);
      for (const Index m : crowd.members) {
        number_[m] = -1;
        const std::size_t first = std::exchange(owner[m], k);
        if (first == k || first == hits.size()) continue;
        for (const Index moved : std::exchange(hits[first], {})) hits[k].push_back(moved);
        std::replace(owner.begin(), owner.end(), first, k);
      }
    }
  }
  for (const std::vector<Index>& members : hits) {
    if (members.empty()) continue;
    Gathering crowd;
    for (const Index m : members) {
      if (number_[m] < 0) join(crowd, m, now);
    }
    hit_crowd(crowd, now);
  }
}

// How fast a contact's bodies approach.
template <class P>
double Tile<P>::approach(const Gathering& crowd, std::size_t contact) const {
  const CrowdContact& c = crowd.contacts[contact];
  const auto velocity = [&](int body) {
    return body == kWall ? Vec<double>{0, 0}
                         : crowd.bodies[static_cast<std::size_t>(body)].velocity;
  };
  return -sharp_dot(c.normal, velocity(c.b) - velocity(c.a));
}

// What meets now, and who stays.
template <class P>
auto Tile<P>::hits_of(const Gathering& crowd, At now) const -> Hits {
  Hits hits;
  hits.stays.resize(crowd.members.size(), 0);
  hits.counted.resize(crowd.contacts.size(), 0);
  const auto disk_of = [&](int body) -> const Disk& {
    return disks_[crowd.members[static_cast<std::size_t>(body)]];
  };
  const auto speed_of_step = static_cast<double>(motion_.speed_of_step());
  hits.fastest = speed_of_step;
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const CrowdContact& c = crowd.contacts[k];
    const typename Gathering::Near& near = crowd.near[k];
    if (!near.touches) continue;
    const auto a = static_cast<std::size_t>(c.a);
    const double speed = approach(crowd, k);
    if (speed < -kStill * speed_of_step) continue;
    hits.fastest = std::max(hits.fastest, speed);
    const bool wall = near.partner >= kFirstMark && c.b == kWall;
    if (wall && crowd.carried[a] < kResting && !(speed > 0)) continue;
    bool clings = false;
    if (wall) {
      clings = crowd.carried[a] >= kResting && motion_.clings_to_wall(disk_of(c.a), S(speed), now);
    } else {
      const Disk& partner = c.b == kWall ? disks_[near.partner] : disk_of(c.b);
      clings = motion_.clings(disk_of(c.a), partner, near.r, now);
    }
    if (speed > 0) {
      ++(wall ? hits.walls : hits.balls);
      hits.counted[k] = 1;
    }
    if (clings) {
      hits.stays[a] = 1;
      if (c.b != kWall) hits.stays[static_cast<std::size_t>(c.b)] = 1;
    } else if (speed > 0) {
      hits.bounces = true;
      hits.restitution = std::min(
          hits.restitution, wall ? motion_.rules().wall_restitution : motion_.rules().restitution);
    }
  }
  return hits;
}

// A hit of a crowd whose contacts lose nothing along their normals is a joint impact of all that
// touches; who is pressed on afterwards, and has no speed along the normal, stays.
template <class P>
void Tile<P>::reflect_crowd(Gathering& crowd, Hits& hits) {
  std::vector<Body<double>> bodies;
  for (const CrowdBody& body : crowd.bodies) bodies.push_back({body.velocity, body.inverse_mass});
  std::vector<Contact<double>> contacts;
  std::vector<std::size_t> number;
  const double restitution = gives_up() ? 0 : 1;
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const CrowdContact& c = crowd.contacts[k];
    if (!crowd.near[k].touches) continue;
    if (c.b != kWall) {
      contacts.push_back({c.a, c.b, in_double(crowd.near[k].r), restitution});
    } else if (crowd.near[k].partner >= kFirstMark) {
      contacts.push_back({c.a, kWall, c.normal, restitution});
    } else {
      contacts.push_back(
          {c.a, static_cast<int>(bodies.size()), in_double(crowd.near[k].r), restitution});
      bodies.push_back({{0, 0}, 0});
    }
    number.push_back(k);
  }
  if (hits.walls + hits.balls > 0) {
    const JointReport report = joint_impact<double>(bodies, contacts);
    counts_.jammed += gives_up() ? contacts.size() : static_cast<std::uint64_t>(report.jammed);
    hits.held = report.held_energy;
    for (std::size_t m = 0; m < crowd.bodies.size(); ++m) {
      crowd.bodies[m].velocity = bodies[m].velocity;
    }
  }
  std::fill(hits.stays.begin(), hits.stays.end(), 0);
  const Vec<double> g = in_double(motion_.law().pull());
  for (const std::size_t k : number) {
    const CrowdContact& c = crowd.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    const bool wall = c.b == kWall && crowd.near[k].partner >= kFirstMark;
    if (wall) continue;
    // Two that fall press each other only where something holds one of them.
    const double pressing = c.b == kWall ? dot(c.normal, g) : 0;
    const double away = std::abs(approach(crowd, k));
    const auto reach = static_cast<double>(root(S(dot(crowd.near[k].r, crowd.near[k].r))));
    const auto pull = static_cast<double>(motion_.pull());
    if (!barely_hops(away, c.b == kWall ? pressing : pull, reach, kAtOnce) && away != 0) continue;
    if (c.b == kWall && !(pressing > 0)) continue;
    hits.stays[a] = 1;
    if (c.b != kWall) hits.stays[static_cast<std::size_t>(c.b)] = 1;
  }
}

// What meets a wall is exactly there, and does not go into it; where energy is kept, what is still
// a little above it stays there.
template <class P>
void Tile<P>::put_on_walls(Gathering& crowd) const {
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const CrowdContact& c = crowd.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    const Index wall = crowd.near[k].partner;
    if (c.b != kWall || wall < kFirstMark || !crowd.near[k].touches) continue;
    if (motion_.elastic() && c.gap > 0) continue;
    const Disk& disk = disks_[crowd.members[a]];
    const std::size_t axis = (wall - kWalls) / 2;
    put_at(crowd, crowd.places[a], axis, motion_.wall(disk, crowd.places[a], wall).stop,
           motion_.kind(disk).inverse_mass);
    double& v = axis == 0 ? crowd.bodies[a].velocity.x : crowd.bodies[a].velocity.y;
    if ((axis == 0 ? c.normal.x : c.normal.y) * v > 0) v = 0;
  }
}

template <class P>
void Tile<P>::hit_crowd(Gathering& crowd, At now) {
  const Stopwatch stopwatch(true, crowd_seconds_);
  gather(crowd, now);
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    if (!crowd.near[k].touches) continue;
    const int b = crowd.contacts[k].b;
    const Index other =
        b == kWall ? crowd.near[k].partner : crowd.members[static_cast<std::size_t>(b)];
    resolved_.push_back({crowd.members[static_cast<std::size_t>(crowd.contacts[k].a)], other});
  }
  schedule_step(now);
  double span = 0;  // until the next step; 0: for ever
  if (next_step_ != P::Clock::never()) {
    span = static_cast<double>(S(motion_.rules().scale.seconds(next_step_ - now)));
  }
  const double rate = span > 0 ? 1 / span : 0;
  Hits hits = hits_of(crowd, now);
  counts_.ball_wall += hits.walls;
  counts_.ball_ball += hits.balls;
  if (hits.walls + hits.balls > 1) ++counts_.joint_impacts;

  const double had = energy_of(crowd, span).all();
  const double goal = kSolved * hits.fastest;
  const bool elastic = motion_.elastic();
  CrowdLog log;
  const Vec<double> g = in_double(motion_.law().pull());
  if (elastic) {
    reflect_crowd(crowd, hits);
  } else if (hits.bounces && hits.restitution > 0) {
    const std::vector<CrowdBody> before = crowd.bodies;
    log.impulses = Crowd(crowd.bodies, crowd.contacts).resolve(crowd.bodies, rate, goal);
    const double e = hits.restitution;
    const auto beyond = [e](double was, double is) { return is + e * (is - was); };
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
    if (carried == kResting && log_ != nullptr) log_wake(crowd.members[m], now);
    const bool of_it = (carried >= kResting && !elastic) || hits.stays[m] != 0;
    if (of_it && carried != kStepped) {
      // It has not been given what gravity makes till the next step.
      crowd.bodies[m].velocity = crowd.bodies[m].velocity + span * g;
    }
    carried = of_it ? kStepped : 0;
  }
  if (rested) ++counts_.wakes;
  std::vector<double> loads(crowd.contacts.size(), 0);
  hold_on(crowd, span, goal, loads);
  put_on_walls(crowd);
  if (keep_energy(crowd, had - 2 * hits.held, span) && !motion_.keeps_energy()) {
    hold_on(crowd, span, goal, loads);
    put_on_walls(crowd);
  }
  const double lost = loss_of(crowd, had, span);
  const std::size_t first_line = log_ != nullptr ? log_->impacts.size() : 0;
  if (log_ != nullptr) {
    log.counted = hits.counted;
    log.impulses.resize(loads.size(), 0);
    for (std::size_t k = 0; k < loads.size(); ++k) {
      log.impulses[k] = (1 + hits.restitution) * log.impulses[k] + loads[k];
    }
    log.lost = lost;
    log_crowd(crowd, log, now);
  }

  book_.correct(lost);
  log_loss(first_line, fly_on(crowd, now));
}

template <class P>
void Tile<P>::step_crowds(At now) {
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
  begin_instant();  // what comes now takes no step back
}

// Twice what the energy of a crowd is but for its height: what moves, less what gravity has given
// ahead to those that are stepped, for the time of `span`.
template <class P>
auto Tile<P>::energy_of(const Gathering& crowd, double span) const -> CrowdEnergy {
  const Vec<double> g = in_double(motion_.law().pull());
  ExactSum<double> stepped;
  ExactSum<double> ahead;
  ExactSum<double> others;
  for (std::size_t m = 0; m < crowd.bodies.size(); ++m) {
    const CrowdBody& body = crowd.bodies[m];
    const double mass = 1 / body.inverse_mass;
    const bool steps = crowd.carried[m] == kStepped;
    ExactSum<double>& moving = steps ? stepped : others;
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
// was. Where nothing loses any, all of the crowd keeps what it had, by one factor.
template <class P>
bool Tile<P>::keep_energy(Gathering& crowd, double had, double span) const {
  const CrowdEnergy now = energy_of(crowd, span);
  const bool keeps = motion_.keeps_energy();
  if (keeps) had -= 2 * crowd.lifted;
  const double moving = keeps ? now.stepped + now.others : now.stepped;
  const double rest = keeps ? had : had - now.others;
  const bool only_less = !keeps || gives_up();
  if ((only_less && !(now.all() > had)) || !(moving > 0)) return false;
  // moving a^2 - ahead a = rest, for the largest a, or the one next to 1
  const double half = now.ahead / 2;
  const double square = half * half + moving * rest;
  double a = square > 0 ? (half + std::sqrt(square)) / moving : 0.0;
  if (keeps && square > 0) {
    const double other = (half - std::sqrt(square)) / moving;
    if (std::abs(other - 1) < std::abs(a - 1)) a = other;
  }
  a = std::max(a, 0.0);
  if (keeps ? a == 1 : !(a < 1)) return false;
  for (std::size_t m = 0; m < crowd.bodies.size(); ++m) {
    if (!keeps && crowd.carried[m] != kStepped) continue;
    CrowdBody& body = crowd.bodies[m];
    body.velocity = a * body.velocity;
    body.turning = a * body.turning;
  }
  return true;
}

// Impulses by which nothing closes before the next step; where impacts are elastic, only among
// those that stay, as others meet at their own time.
template <class P>
void Tile<P>::press(Gathering& crowd, double span, double goal, std::vector<double>& loads) const {
  const auto steps = [&](int body) {
    return body == kWall || crowd.carried[static_cast<std::size_t>(body)] == kStepped;
  };
  std::vector<CrowdContact> contacts;
  std::vector<std::size_t> number;
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const CrowdContact& c = crowd.contacts[k];
    if (motion_.elastic() && !(steps(c.a) && steps(c.b))) continue;
    contacts.push_back(c);
    number.push_back(k);
  }
  const double rate = span > 0 ? 1 / span : 0;
  Crowd whole(crowd.bodies, contacts);
  const std::vector<double> impulses = whole.resolve(crowd.bodies, rate, goal);
  for (std::size_t k = 0; k < number.size(); ++k) loads[number[k]] += impulses[k];
}

// What leaves a crowd, and still comes nearer to what it touches, stays.
template <class P>
void Tile<P>::hold_on(Gathering& crowd, double span, double goal,
                      std::vector<double>& loads) const {
  const Vec<double> g = in_double(motion_.law().pull());
  for (bool more = true; more;) {
    press(crowd, span, goal, loads);
    more = false;
    for (std::size_t k = 0; k < crowd.contacts.size() && !motion_.elastic(); ++k) {
      const CrowdContact& c = crowd.contacts[k];
      const bool wall = c.b == kWall && crowd.near[k].partner >= kFirstMark;
      if (wall || !crowd.near[k].touches || !(approach(crowd, k) > 0)) continue;
      for (const int body : {c.a, c.b}) {
        if (body == kWall) continue;
        unsigned& carried = crowd.carried[static_cast<std::size_t>(body)];
        if (carried == kStepped) continue;
        carried = kStepped;
        Vec<double>& v = crowd.bodies[static_cast<std::size_t>(body)].velocity;
        v = v + span * g;
        more = true;
      }
    }
  }
}

// What the contacts of a crowd have taken is what it has less. That may be less than nothing: a
// ball that joins is given ahead a fall that a contact found later at the same instant takes back.
template <class P>
double Tile<P>::loss_of(const Gathering& crowd, double had, double span) const {
  // What was lifted onto a wall has that much more, which nothing took.
  return (had - energy_of(crowd, span).all()) / 2 - crowd.lifted;
}

template <class P>
double Tile<P>::given_ahead(At now) const {
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
                         const std::vector<char>& carries, std::vector<char>& moves) const {
  const std::size_t n = crowd.members.size();
  const auto find = [&set](std::size_t k) {
    while (set[k] != k) k = set[k] = set[set[k]];
    return k;
  };
  const auto span = static_cast<double>(
      S(motion_.rules().scale.seconds(P::Clock::span(1, motion_.step_shift()))));
  const auto speed = static_cast<double>(motion_.speed_of_step());
  const Vec<double> g = in_double(motion_.law().pull());
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
void Tile<P>::step_crowd(Gathering& crowd, At now) {
  ++counts_.steps;
  const std::size_t n = crowd.members.size();
  const Vec<double> g = in_double(motion_.law().pull());
  const auto span = static_cast<double>(
      S(motion_.rules().scale.seconds(P::Clock::span(1, motion_.step_shift()))));
  const auto speed = static_cast<double>(motion_.speed_of_step());
  const double still = (motion_.elastic() ? kStill * kStill : kStill) * speed;
  const std::vector<CrowdBody> before = crowd.bodies;
  const double had = energy_of(crowd, 0).all();
  for (CrowdBody& body : crowd.bodies) body.velocity = body.velocity + span * g;
  Crowd whole(crowd.bodies, crowd.contacts);
  const double goal = (motion_.elastic() ? kSolved * kSolved : kSolved) * speed;
  const std::vector<double> loads = whole.resolve(crowd.bodies, 1 / span, goal, true);

  std::vector<std::size_t> set(n);
  std::iota(set.begin(), set.end(), 0U);
  const auto find = [&set](std::size_t k) {
    while (set[k] != k) k = set[k] = set[set[k]];
    return k;
  };
  std::vector<int> loaded(n, 0);
  std::vector<char> on_balls(n, 0);
  std::vector<char> approaches(n, 0);
  std::vector<char> carries(crowd.contacts.size(), 0);
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const CrowdContact& c = crowd.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    const auto b = c.b == kWall ? a : static_cast<std::size_t>(c.b);
    const double mobility =
        crowd.bodies[a].inverse_mass + (c.b == kWall ? 0 : crowd.bodies[b].inverse_mass);
    const Vec<double> other = c.b == kWall ? Vec<double>{0, 0} : before[b].velocity;
    if (dot(c.normal, other - before[a].velocity) < -still) approaches[a] = approaches[b] = 1;
    if (!(loads[k] * mobility > kLoaded * speed)) continue;
    carries[k] = 1;
    ++loaded[a];
    const bool wall = c.b == kWall && crowd.near[k].partner >= kFirstMark;
    if (!wall) on_balls[a] = 1;
    if (c.b == kWall) continue;
    ++loaded[b];
    on_balls[b] = 1;
    set[find(a)] = find(b);
  }
  std::vector<char> restless(n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    const CrowdBody& body = crowd.bodies[m];
    // Who rests already is not woken by what has not been solved to the end.
    const double most = crowd.carried[m] == kResting ? 4 * still : still;
    if (std::abs(body.velocity.x) > most || std::abs(body.velocity.y) > most ||
        std::abs(body.turning) > most || loaded[m] == 0) {
      restless[m] = 1;
    }
  }
  // On a single fixed ball it rests only straight above it.
  for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
    const CrowdContact& c = crowd.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    if (carries[k] == 0 || c.b != kWall || crowd.near[k].partner >= kFirstMark) continue;
    const Vec<double> r = in_double(crowd.near[k].r);
    const double off = std::abs(cross(r, g));
    if (loaded[a] == 1 && off > 0x1p-40 * std::abs(dot(r, g))) restless[a] = 1;
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
      body.velocity = {0, 0};
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
    if (motion_.elastic() && c.gap > 0) continue;
    const bool x = wall - kWalls < 2;
    const Disk& disk = disks_[crowd.members[a]];
    put_at(crowd, crowd.places[a], x ? 0 : 1, motion_.wall(disk, crowd.places[a], wall).stop,
           motion_.kind(disk).inverse_mass);
    // Only walls carry it: it slides on, or rolls, if it does not come to rest.
    if (on_balls[a] != 0 || approaches[a] != 0) continue;
    const bool rests = crowd.carried[a] == kResting && !motion_.elastic();
    if (crowd.carried[a] != 0 && !rests) crowd.bodies[a] = before[a];
    (x ? crowd.bodies[a].velocity.x : crowd.bodies[a].velocity.y) = 0;
    crowd.carried[a] = 0;
  }
  keep_energy(crowd, had, span);
  const double lost = loss_of(crowd, had, span);
  const std::size_t first_line = log_ != nullptr ? log_->impacts.size() : 0;
  if (log_ != nullptr) {
    CrowdLog log;
    log.counted.resize(loads.size(), 0);
    log.impulses = loads;
    log.lost = lost;
    log_crowd(crowd, log, now);
  }
  book_.correct(lost);
  log_loss(first_line, fly_on(crowd, now));
}

}  // namespace carom::event
