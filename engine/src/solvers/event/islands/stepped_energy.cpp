#include "solvers/event/islands/stepped_energy.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "numbers/exact_sum.hpp"
#include "solvers/event/support.hpp"

namespace carom::event {

auto SteppedEnergy::of(const IslandMotion& island, double span) const -> Parts {
  const Vec<double>& g = rules_.pull;
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

double SteppedEnergy::loss(const IslandMotion& island, double had, double span) const {
  // What was lifted onto a wall has that much more, which nothing took.
  return (had - of(island, span).all()) / 2 - island.lifted;
}

bool SteppedEnergy::keep(IslandMotion& island, double had, double span, bool gives_up) const {
  const Parts now = of(island, span);
  const bool keeps = rules_.keeps;
  if (keeps) had -= 2 * island.lifted;
  const double moving = keeps ? now.stepped + now.others : now.stepped;
  const double rest = keeps ? had : had - now.others;
  const bool only_less = !keeps || gives_up;
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

bool SteppedEnergy::can_go(const IslandMotion& island, double a, double span) const {
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (a * approach(island, k) * span > island.contacts[k].gap + rules_.touching) return false;
  }
  return true;
}

bool SteppedEnergy::is_held(const IslandMotion& island, double lost) const {
  if (!rules_.keeps) return false;
  double most = 0;
  for (const ConeBody& body : island.bodies)
    most += rules_.still * rules_.still / body.inverse_mass;
  return std::abs(lost) > most;
}

}  // namespace carom::event
