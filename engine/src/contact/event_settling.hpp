#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "contact/event_carrying_forces.hpp"

namespace carom::event {

/// Two bodies that touch or nearly do, or a body and a wall near it.
template <class S>
struct NearContact {
  int a;
  int b;     ///< a body, or kWall
  Vec<S> r;  ///< from the centre of a to that of b, or a unit along the axis towards the wall
  S reach;   ///< the distance of contact; for a wall: the gap that is left
};

/// Where a group of balls ends up that sinks a little way along its pull, and what carries it then.
template <class S>
struct Settled {
  std::vector<Vec<S>> shift;  ///< by body
  std::vector<S> loads;       ///< by contact, >= 0
  std::vector<char> still;    ///< by body: the last step did not move it
};

/// How far contacts give way, as a part of the step for each weight they carry: it makes the
/// forces of a group with more contacts than freedoms definite.
inline constexpr double kGive = 0x1p-16;
inline constexpr int kSettlingSteps = 24;
/// What may remain of the pull where forces carry a body.
inline constexpr double kStill = 0x1p-16;

/// Lets bodies sink along `pull`, step by step: each step moves them by `pull` and by the least
/// impulses that keep every contact from closing beyond touching. Where forces can carry the
/// group this ends after a few steps, quadratically, with all loaded contacts closed; where they
/// cannot, a body goes on.
template <class S>
Settled<S> settle(std::span<const Body<S>> bodies, std::span<const NearContact<S>> near,
                  const Vec<S>& pull, const S& most) {
  Settled<S> result;
  result.shift.assign(bodies.size(), {S(0), S(0)});
  result.loads.assign(near.size(), S(0));
  result.still.assign(bodies.size(), 1);
  const S size = larger(absolute(pull.x), absolute(pull.y));
  const auto shift_of = [&](int body) {
    return body == kWall ? Vec<S>{S(0), S(0)} : result.shift[static_cast<std::size_t>(body)];
  };
  std::vector<Contact<S>> contacts;
  for (const NearContact<S>& c : near) contacts.push_back({c.a, c.b, c.r, S(0)});
  double times = 1;
  for (int round = 0; round < kSettlingSteps; ++round) {
    std::vector<Vec<S>> motion(bodies.size(), S(times) * pull);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      if (bodies[k].inverse_mass == 0) motion[k] = {S(0), S(0)};
    }
    std::vector<S> gaps(near.size());
    for (std::size_t k = 0; k < near.size(); ++k) {
      const NearContact<S>& c = near[k];
      if (c.b == kWall) {
        gaps[k] = c.reach - dot(c.r, shift_of(c.a));
      } else {
        const Vec<S> r = c.r + (shift_of(c.b) - shift_of(c.a));
        contacts[k].r = r;
        gaps[k] = squared_gap(r, c.reach) / (root(S(r.x * r.x + r.y * r.y)) + c.reach);
      }
    }
    const CarryingForces<S> forces(bodies, contacts, S(kGive / times));
    for (std::size_t k = 0; k < near.size(); ++k) gaps[k] = gaps[k] + forces.parting(k, motion);
    const S tolerance = times * size * S(kStill);
    forces.solve(gaps, S(tolerance / 16), result.loads);
    const std::vector<Vec<S>> changes = forces.changes(result.loads);
    bool all = true;
    bool hopeless = true;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const Vec<S> step = motion[k] + changes[k];
      Vec<S>& shift = result.shift[k];
      shift = shift + step;
      const bool still = absolute(step.x) <= tolerance && absolute(step.y) <= tolerance;
      result.still[k] = still ? 1 : 0;
      if (still) continue;
      all = false;
      if (absolute(shift.x) <= most && absolute(shift.y) <= most) hopeless = false;
    }
    if (all ? times == 1 : hopeless) break;
    // Slopes that are nearly level take longer steps; what is reached by them is settled again.
    const double next = all ? 1 : (round < 3 ? times : std::min(times * 2, 256.0));
    for (S& load : result.loads) load = load * (next / times);
    times = next;
  }
  return result;
}

/// Which bodies of a settled group rest: those that no step moved any more, all of whose partners
/// in loaded contacts rest, and that have not sunk by more than `most`. A ball that one contact
/// carries balances on it: it rests only straight above it.
template <class S>
std::vector<char> resting_bodies(std::span<const Body<S>> bodies,
                                 std::span<const NearContact<S>> near, const Settled<S>& settled,
                                 const S& most, const Vec<S>& pull) {
  std::vector<std::size_t> set(bodies.size());
  for (std::size_t k = 0; k < set.size(); ++k) set[k] = k;
  const auto find = [&set](std::size_t k) {
    while (set[k] != k) k = set[k] = set[set[k]];
    return k;
  };
  std::vector<char> restless(bodies.size(), 0);
  std::vector<int> loaded(bodies.size(), 0);
  std::vector<char> paired(bodies.size(), 0);
  for (std::size_t k = 0; k < near.size(); ++k) {
    if (!(settled.loads[k] > 0)) continue;
    const auto a = static_cast<std::size_t>(near[k].a);
    ++loaded[a];
    if (near[k].b == kWall) continue;
    const auto b = static_cast<std::size_t>(near[k].b);
    paired[a] = 1;
    paired[b] = 1;
    ++loaded[b];
    if (bodies[b].inverse_mass > 0 && bodies[a].inverse_mass > 0) set[find(a)] = find(b);
  }
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Vec<S>& shift = settled.shift[k];
    if (!settled.still[k] || absolute(shift.x) > most || absolute(shift.y) > most ||
        loaded[k] == 0) {
      restless[k] = 1;
    }
  }
  for (std::size_t k = 0; k < near.size(); ++k) {
    if (!(settled.loads[k] > 0) || near[k].b == kWall) continue;
    const S off = absolute(cross(near[k].r, pull));
    if (!(off > std::ldexp(1.0, -40) * absolute(dot(near[k].r, pull)))) continue;
    for (const int body : {near[k].a, near[k].b}) {
      const auto at = static_cast<std::size_t>(body);
      if (loaded[at] == 1) restless[at] = 1;
    }
  }
  std::vector<char> result(bodies.size(), 1);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].inverse_mass > 0 && restless[k] != 0) result[find(k)] = 0;
  }
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    result[k] = bodies[k].inverse_mass > 0 && result[find(k)] != 0 && paired[k] != 0 ? 1 : 0;
  }
  return result;
}

}  // namespace carom::event
