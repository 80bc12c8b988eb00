#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/joint_impact.hpp"
#include "contact/rest_rules.hpp"
#include "solvers/event/islands/island_impact.hpp"
#include "solvers/event/islands/put_on_wall.hpp"

namespace carom::event {

// What an impact may make, as a part of the energy, before what bounces in it bounces less: where
// slowing down others makes up for it, and where that is not enough.
inline constexpr double kMade = 0x1p-4;
inline constexpr double kMadeForGood = 0x1p-20;
// Contacts that miss what is asked of them by more than so many times what may remain have no room.
inline constexpr double kAmiss = 64;
// What bounces less bounces half as much, and less than this part not at all.
inline constexpr double kLeastPart = 0x1p-4;

// Who leaves falls by itself until the next step: what gravity has given it ahead is taken back, or
// given if it is owed, but for what the contacts that it presses on have taken of that: those at
// rest, and those that close their gap just until the step, in `way` from now.
template <class P>
void IslandImpact<P>::take_back(Island& island, double way) const {
  const double part = motion_.whole_flight().given();
  const Vec<double> given = part * in_double(motion_.law().pull());
  std::vector<ConeBody> ahead = island.bodies;
  for (std::size_t m = 0; m < ahead.size(); ++m) {
    ahead[m].velocity = island.support[m] >= kResting ? given : Vec<double>{0, 0};
    ahead[m].turning = 0;
  }
  const auto is_of_it = [&](int body) {
    return body == kWall || island.support[static_cast<std::size_t>(body)] >= kResting;
  };
  const double still = kStill * static_cast<double>(motion_.speed_of_step());
  std::vector<ConeContact> pressed;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    if (!is_of_it(c.a) || !is_of_it(c.b) || (island.touches[k] == 0 && !(way > 0))) continue;
    const double closing = island.touches[k] != 0 ? 0 : c.gap / way;
    if (std::abs(approach(island, k) - closing) > still) continue;
    pressed.push_back(c);
    pressed.back().gap = 0;
  }
  ConeIsland(ahead, pressed).resolve(ahead, 0, kSolved * still);
  for (std::size_t m = 0; m < ahead.size(); ++m) {
    const double owed = std::exchange(island.gravity[m], {}).owed / part;
    if (island.support[m] != kStepped) continue;
    island.bodies[m].velocity = island.bodies[m].velocity + owed * ahead[m].velocity;
    island.bodies[m].turning += owed * ahead[m].turning;
  }
}

// A hit of an island whose contacts lose nothing along their normals is a joint impact of all that
// touches.
template <class P>
auto IslandImpact<P>::reflect(Island& island) const -> Reflection {
  std::vector<Body<double>> bodies;
  for (const ConeBody& body : island.bodies) bodies.push_back({body.velocity, body.inverse_mass});
  std::vector<Contact<double>> contacts;
  const auto restitution = [this](double of_impact) { return impulses_.loses() ? 0 : of_impact; };
  const double of_balls = restitution(static_cast<double>(motion_.rules().restitution));
  const double of_walls = restitution(static_cast<double>(motion_.rules().wall_restitution));
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    if (island.touches[k] == 0) continue;
    if (c.b != kWall) {
      contacts.push_back({c.a, c.b, in_double(island.near[k].r), of_balls});
    } else if (is_at_wall(island, k)) {
      contacts.push_back({c.a, kWall, c.normal, of_walls});
    } else {
      contacts.push_back(
          {c.a, static_cast<int>(bodies.size()), in_double(island.near[k].r), of_balls});
      bodies.push_back({{0, 0}, 0});
    }
  }
  const JointReport report =
      joint_impact<double>(bodies, contacts, impulses_.gives_up() && motion_.elastic());
  for (std::size_t m = 0; m < island.bodies.size(); ++m) {
    island.bodies[m].velocity = bodies[m].velocity;
  }
  return {impulses_.gives_up() ? contacts.size() : static_cast<std::uint64_t>(report.jammed),
          report.held_energy};
}

// What is pressed on after a joint impact, and has no speed along the normal, stays.
template <class P>
void IslandImpact<P>::note_who_stays(const Island& island, IslandHits& hits) const {
  std::fill(hits.stays.begin(), hits.stays.end(), 0);
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (island.touches[k] == 0) continue;
    const ConeContact& c = island.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    if (is_at_wall(island, k)) continue;
    // Two that fall press each other only where something holds one of them.
    const Disk& disk = disks_[island.members[a]];
    const double pressing =
        c.b == kWall ? dot(c.normal, in_double(motion_.law_of(disk).pull())) : 0;
    const double away = impulses_.gives_up() ? 0 : std::abs(approach(island, k));
    const auto reach = static_cast<double>(root(S(dot(island.near[k].r, island.near[k].r))));
    const auto pull = static_cast<double>(motion_.pull());
    if (!barely_bounces(away, c.b == kWall ? pressing : pull, reach, kAtOnce) && away != 0)
      continue;
    if (c.b == kWall && !(pressing > 0) && !impulses_.gives_up()) continue;
    hits.stays[a] = 1;
    if (c.b != kWall) hits.stays[static_cast<std::size_t>(c.b)] = 1;
  }
}

// What meets a wall is exactly there, and does not go into it; where energy is kept, what is still
// a little above it stays there.
template <class P>
void IslandImpact<P>::put_on_walls(Island& island) const {
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const auto a = static_cast<std::size_t>(c.a);
    const Index wall = island.near[k].partner;
    if (!is_at_wall(island, k) || island.touches[k] == 0) continue;
    if (motion_.elastic() && c.gap > 0) continue;
    island.lifted += put_on_wall(motion_, disks_[island.members[a]], wall, island.places[a]);
    stop_at(island.bodies[a], c);
  }
}

// What leaves an island, and still comes nearer to what it touches, stays.
template <class P>
void IslandImpact<P>::hold_on(Island& island, const Try& of, std::vector<double>& loads) const {
  if (motion_.elastic()) {
    hold_elastic(island, of, loads);
    return;
  }
  for (bool more = true; more;) {
    impulses_.press(island, of.next, of.goal, loads, of.opens);
    more = false;
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      const ConeContact& c = island.contacts[k];
      const bool wall = is_at_wall(island, k);
      if (wall || island.touches[k] == 0 || !(approach(island, k) > 0)) continue;
      for (const int body : {c.a, c.b}) {
        if (body == kWall) continue;
        const auto m = static_cast<std::size_t>(body);
        if (island.support[m] == kStepped) continue;
        island.support[m] = kStepped;
        pull(island, m, of.next);
        more = true;
      }
    }
  }
}

// The same where energy is kept: what leaves has parted, and comes back only as gravity is ahead of
// what is stepped.  Then it is stepped, too, and all are held again from the start.
template <class P>
void IslandImpact<P>::hold_elastic(Island& island, const Try& of,
                                   std::vector<double>& loads) const {
  for (;;) {
    const std::vector<ConeBody> start = island.bodies;
    impulses_.press(island, of.next, of.goal, loads, of.opens);
    if (!(of.next.seconds > 0)) return;
    for (int turn = 0; turn < kMostTurns && impulses_.closes(island, of.next); ++turn) {
      impulses_.press(island, of.next, of.goal, loads, of.opens);
    }
    const std::vector<std::size_t> coming = who_comes_back(island, of.next);
    if (coming.empty()) return;
    island.bodies = start;
    std::fill(loads.begin(), loads.end(), 0.0);
    for (const std::size_t m : coming) {
      island.support[m] = kStepped;
      pull(island, m, of.next);
    }
  }
}

template <class P>
std::vector<std::size_t> IslandImpact<P>::who_comes_back(const Island& island,
                                                         const SteppedFlight& next) const {
  std::vector<std::size_t> coming;
  const auto steps = [&](int body) {
    return body != kWall && island.support[static_cast<std::size_t>(body)] == kStepped;
  };
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    if (is_at_wall(island, k) || island.touches[k] == 0 || steps(c.a) == steps(c.b)) continue;
    if (c.b == kWall || !impulses_.lasts(island, k) || !impulses_.closes(island, k, next)) continue;
    const auto m = static_cast<std::size_t>(steps(c.a) ? c.b : c.a);
    if (std::find(coming.begin(), coming.end(), m) == coming.end()) coming.push_back(m);
  }
  return coming;
}

// What comes to many is turned round ahead of its impact: at a place where it will be as fast as
// this on its way back. It then has what gravity makes in the first half of its flight.
template <class P>
double IslandImpact<P>::parting(const Island& island, std::size_t k, const IslandHits& hits,
                                const SteppedFlight& next) const {
  if (!is_large(island)) return hits.restitution * approach(island, k);
  const ConeContact& c = island.contacts[k];
  const bool wall = is_at_wall(island, k);
  const auto restitution =
      static_cast<double>(wall ? motion_.rules().wall_restitution : motion_.rules().restitution);
  const double away = restitution * approach(island, k);
  double pressing = 0;
  for (const int body : {c.a, c.b}) {
    if (body == kWall || island.support[static_cast<std::size_t>(body)] >= kResting) continue;
    const Disk& disk = disks_[island.members[static_cast<std::size_t>(body)]];
    const double pull = dot(c.normal, in_double(motion_.law_of(disk).pull()));
    pressing += body == c.a ? pull : -pull;
  }
  const double lower = 2 * pressing * std::max(c.gap, 0.0) * (1 - restitution) * (1 + restitution);
  const double square = away * away - lower;
  return square > 0 ? std::max(std::sqrt(square) - pressing * next.given(), 0.0) : 0;
}

template <class P>
void IslandImpact<P>::pull(Island& island, std::size_t m, const SteppedFlight& next) const {
  Vec<double>& v = island.bodies[m].velocity;
  v = v + (island.gravity[m].owed + next.given()) * in_double(motion_.law().pull());
}

template <class P>
void IslandImpact<P>::give_support(Island& island, const IslandHits& hits,
                                   const SteppedFlight& next, std::vector<Index>& woken) const {
  const bool keeps_all = !motion_.elastic() || impulses_.gives_up();
  const bool large = !motion_.elastic() && is_large(island);
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    unsigned& support = island.support[m];
    if (support == kResting) woken.push_back(island.members[m]);
    const bool of_it = (support >= kResting && keeps_all) || hits.stays[m] != 0 || large;
    if (of_it) pull(island, m, next);
    support = of_it ? kStepped : 0;
  }
}

template <class P>
bool IslandImpact<P>::reflects(const Island& island, const IslandHits& hits) const {
  const auto& rules = motion_.rules();
  return !is_large(island) && hits.bounces && !(rules.restitution < 1) &&
         !(rules.wall_restitution < 1) && rules.friction == 0 && rules.wall_friction == 0;
}

template <class P>
bool IslandImpact<P>::has_room(const Island& island, const Try& of) const {
  const double rate = of.next.seconds > 0 ? 1 / of.next.way() : 0;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const double most = c.parting > 0 ? -c.parting : rate * std::max(c.gap, 0.0);
    if (approach(island, k) > most + kAmiss * of.goal) return false;
  }
  return true;
}

// How much of a speed that is stopped may remain.
template <class P>
double IslandImpact<P>::solved_to(double fastest) const {
  const double step = kSolved * static_cast<double>(motion_.speed_of_step());
  const double open =
      kLeftOpen * motion_.largest_radius() / static_cast<double>(motion_.seconds_of_step());
  return std::min(kSolved * fastest, std::max(step, open));
}

// As `hold_on`, with what bounces parting as fast as its contacts ask for, times `part`; no energy
// is made where that can be mended by slowing down what is stepped.
template <class P>
auto IslandImpact<P>::bounce(Island& island, const IslandHits& hits, const Try& of, double part,
                             IslandChange& change) const -> Bounce {
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    island.contacts[k].parting = hits.parts[k] != 0 ? part * of.parting[k] : 0;
  }
  const std::vector<ConeBody> before = island.bodies;
  give_support(island, hits, of.next, change.woken);
  std::vector<double>& loads = change.carried.impulses;
  loads.assign(island.contacts.size(), 0);
  hold_on(island, of, loads);
  put_on_walls(island);
  impulses_.energy().leave_out(island, before, of.next);
  const bool fits = !(part > 0) || has_room(island, of);
  for (ConeContact& contact : island.contacts) contact.parting = 0;
  if (!fits) return Bounce::has_no_room;
  const SteppedEnergy& energy = impulses_.energy();
  const double back = motion_.keeps_energy() ? 0 : energy.given_back(island, of.before, of.next);
  const auto makes = [&](double most) {
    const SteppedEnergy::Parts now = energy.of(island, of.next);
    return now.all() - of.had - back > most * (now.stepped + now.others);
  };
  if (part > 0 && makes(kMade)) return Bounce::makes_energy;
  if (energy.keep(island, of.kept + back, of.next, impulses_.loses())) {
    if (motion_.keeps_energy()) {
      impulses_.keep_gaps(island, of.kept, of.next, of.goal, loads);
    } else {
      hold_on(island, of, loads);
      put_on_walls(island);
    }
  }
  return part > 0 && makes(kMadeForGood) ? Bounce::makes_energy : Bounce::done;
}

template <class P>
IslandChange IslandImpact<P>::resolve(Island& island, const SteppedFlight& next, At now,
                                      Kind kind) const {
  const bool steps = kind != Kind::impact;
  IslandChange change;
  Counts& counts = change.counts;
  IslandHits hits = hits_of(motion_, disks_, island, now, steps);
  if (steps) counts.steps = 1;
  counts.ball_wall = hits.walls;
  counts.ball_ball = hits.balls;
  if (hits.all() > 1) counts.joint_impacts = 1;

  const SteppedEnergy& energy = impulses_.energy();
  const double had = energy.so_far(island);
  std::vector<ConeBody> before = island.bodies;
  const bool elastic = motion_.elastic();
  // What a joint impact has left is only what gravity makes until the next step.
  const double goal = elastic ? std::max(kSolved * static_cast<double>(motion_.speed_of_step()),
                                         kSolved * kSolved * hits.fastest) *
                                    kSolved
                              : solved_to(hits.fastest);
  const double opens = steps ? impulses_.opens() : 0;
  if (elastic) take_back(island, steps ? 0 : next.way());
  double held = 0;
  std::vector<double> parting(island.contacts.size(), 0);
  const auto reflect = [&] {
    const Reflection reflection = this->reflect(island);
    counts.jammed = reflection.jammed;
    held = reflection.held;
  };
  const bool joint = !elastic && (kind == Kind::turn || reflects(island, hits));
  if (joint || (elastic && hits.all() > 0)) reflect();
  if (elastic) {
    note_who_stays(island, hits);
  } else if (hits.bounces) {
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      if (hits.parts[k] != 0) parting[k] = this->parting(island, k, hits, next);
    }
  }
  const Try of{std::move(parting), next, goal, opens, std::move(before), had, had - 2 * held};
  if (elastic || joint || !hits.bounces) {
    (void)bounce(island, hits, of, 0, change);
  } else {
    // In a wedge what parts as fast as it is asked to may take others along faster than there is
    // energy for, or have no way to go: then, of few, it is a joint impact.
    const Island was = island;
    double part = 1;
    for (Bounce result; (result = bounce(island, hits, of, part, change)) != Bounce::done;) {
      island = was;
      change.woken.clear();
      part = part > kLeastPart ? part / 2 : 0;
      if (result == Bounce::makes_energy || is_large(island)) continue;
      reflect();
      part = 0;
    }
  }
  if (!change.woken.empty()) counts.wakes = 1;
  const double lost = energy.loss(island, had, next);
  if (!(held > 0) && energy.is_held(island, lost)) ++counts.jammed;
  change.carried.counted = std::move(hits.counted);
  change.carried.lost = lost;
  return change;
}

template <class P>
IslandChange IslandImpact<P>::turn(Island& island, const IslandChange& change, At now) const {
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (!(change.carried.impulses[k] > 0)) continue;
    island.near[k].comes = true;
    island.touches[k] = 1;
  }
  return resolve(island, motion_.whole_flight(), now, Kind::turn);
}

}  // namespace carom::event
