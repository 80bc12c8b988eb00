#pragma once

#include <algorithm>
#include <cmath>

#include "numbers/exact_sum.hpp"
#include "solvers/event/loop_island_search_body.hpp"

namespace carom::event {

// Twice what the energy of an island is but for its height: what moves, less what gravity has given
// ahead to those that are stepped, for the time of `span`.
template <class P>
auto EventLoop<P>::energy_of(const FoundIsland& island, double span) const -> IslandEnergy {
  const Vec<double> g = in_double(motion_.law().pull());
  ExactSum<double> stepped;
  ExactSum<double> ahead;
  ExactSum<double> others;
  for (std::size_t m = 0; m < island.bodies.size(); ++m) {
    const ConeBody& body = island.bodies[m];
    const double mass = 1 / body.inverse_mass;
    const bool steps = island.support[m] == kStepped;
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
// was. Where nothing loses any, all of the island keeps what it had, by one factor.
template <class P>
bool EventLoop<P>::keep_energy(FoundIsland& island, double had, double span) const {
  const IslandEnergy now = energy_of(island, span);
  const bool keeps = motion_.keeps_energy();
  if (keeps) had -= 2 * island.lifted;
  const double moving = keeps ? now.stepped + now.others : now.stepped;
  const double rest = keeps ? had : had - now.others;
  const bool only_less = !keeps || gives_up();
  if ((only_less && !(now.all() > had)) || !(moving > 0)) return false;
  // moving a^2 - ahead a = rest, for the largest a, or the one next to 1 if both are positive
  const double half = now.ahead / 2;
  const double square = half * half + moving * rest;
  double a = square > 0 ? (half + std::sqrt(square)) / moving : 0.0;
  if (keeps && square > 0) {
    const double other = (half - std::sqrt(square)) / moving;
    const bool nearer = std::abs(other - 1) < std::abs(a - 1);
    // What slides up and is about to come down goes faster; what is only pressed does not.
    if (nearer && (other > 0 || !can_go(island, a, span))) a = other;
  }
  a = std::max(a, 0.0);
  if (keeps ? a == 1 : !(a < 1)) return false;
  for (std::size_t m = 0; m < island.bodies.size(); ++m) {
    if (!keeps && island.support[m] != kStepped) continue;
    ConeBody& body = island.bodies[m];
    body.velocity = a * body.velocity;
    body.turning = a * body.turning;
  }
  return true;
}

// Whether no contact closes beyond touching if all go `a` times as fast.
template <class P>
bool EventLoop<P>::can_go(const FoundIsland& island, double a, double span) const {
  const double touching = kTouching * motion_.largest_radius();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (a * approach(island, k) * span > island.contacts[k].gap + touching) return false;
  }
  return true;
}

// What the contacts of an island have taken is what it has less. That may be less than nothing: a
// ball that joins is given ahead a fall that a contact found later at the same instant takes back.
template <class P>
double EventLoop<P>::loss_of(const FoundIsland& island, double had, double span) const {
  // What was lifted onto a wall has that much more, which nothing took.
  return (had - energy_of(island, span).all()) / 2 - island.lifted;
}

// Where nothing takes energy, what an island has lost beyond what its resting balls had is held by
// contacts that cannot move: they are jammed.
template <class P>
void EventLoop<P>::note_held(const FoundIsland& island, double lost) {
  if (!motion_.keeps_energy()) return;
  const double still = kStill * kStill * static_cast<double>(motion_.speed_of_step());
  double most = 0;
  for (const ConeBody& body : island.bodies) most += still * still / body.inverse_mass;
  if (std::abs(lost) > most) ++counts_.jammed;
}

template <class P>
double EventLoop<P>::given_ahead(At now) const {
  double sum = 0;
  if (!step_clock_.runs()) return sum;
  for (const Disk& disk : disks_) {
    if (motion_.fixed(disk) || motion_.support(disk) != kStepped) continue;
    sum += motion_.given_ahead(disk, now, step_clock_.next());
  }
  return sum;
}

}  // namespace carom::event
