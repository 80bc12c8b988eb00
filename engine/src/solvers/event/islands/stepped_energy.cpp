#include "solvers/event/islands/stepped_energy.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "numbers/exact_sum.hpp"
#include "solvers/event/islands/open_axes.hpp"
#include "solvers/event/support.hpp"

namespace carom::event {
namespace {

/// What begins to move goes no more than so many times as fast as gravity makes it.
constexpr double kStarts = 4;
/// What is slowed down by more has been left out too much of.
constexpr double kLeast = 0.5;
/// A drift may have more energy than there is by this part of what gravity makes until the next
/// step, and by this part of all, which is rounding.
constexpr double kDrifts = 0x1p-11;
constexpr double kRounded = 0x1p-50;

/// Adds twice the energy of a ball's motion; takes it off where `sign` is -1.
void add_motion(ExactSum<double>& sum, const ConeBody& body, double sign) {
  const double mass = sign / body.inverse_mass;
  sum.add(mass * (body.velocity.x * body.velocity.x));
  sum.add(mass * (body.velocity.y * body.velocity.y));
  sum.add(mass / 2 * (body.turning * body.turning));
}

/// What solves moving a^2 - ahead a = rest; 0 where nothing does.
struct Factors {
  double larger = 0;
  double smaller = 0;
};
Factors factors(double moving, double ahead, double rest) {
  const double half = ahead / 2;
  const double square = half * half + moving * rest;
  if (!(square > 0)) return {};
  return {(half + std::sqrt(square)) / moving, (half - std::sqrt(square)) / moving};
}

}  // namespace

template <class Ahead>
auto SteppedEnergy::sum(const IslandMotion& island, const Ahead& ahead_of) const -> Parts {
  const Vec<double>& g = rules_.pull;
  ExactSum<double> stepped;
  ExactSum<double> ahead;
  ExactSum<double> others;
  for (std::size_t m = 0; m < island.bodies.size(); ++m) {
    const ConeBody& body = island.bodies[m];
    const bool steps = island.support[m] == kStepped;
    add_motion(steps ? stepped : others, body, 1);
    if (!steps) continue;
    const double mass = 1 / body.inverse_mass;
    const double span = 2 * ahead_of(m);
    ahead.add(span * mass * (g.x * body.velocity.x));
    ahead.add(span * mass * (g.y * body.velocity.y));
  }
  ExactSum<double> left_out;
  for (const double energy : island.left_out) left_out.add(2 * energy);
  return {stepped.rounded(), ahead.rounded(), others.rounded(), left_out.rounded()};
}

auto SteppedEnergy::of(const IslandMotion& island, const SteppedFlight& next) const -> Parts {
  const double ahead = next.ahead(0);
  return sum(island, [ahead](std::size_t) { return ahead; });
}

double SteppedEnergy::so_far(const IslandMotion& island) const {
  return sum(island, [&](std::size_t m) { return island.gravity[m].ahead; }).all();
}

// Flights are counted with less than their ends have: what gravity makes in half of one, squared.
double SteppedEnergy::of_leaving(const IslandMotion& island, const std::vector<ConeBody>& before,
                                 const std::vector<unsigned>& were) const {
  const Vec<double>& g = rules_.pull;
  ExactSum<double> more;
  for (std::size_t m = 0; m < before.size(); ++m) {
    if (were[m] != kStepped || island.support[m] >= kResting) continue;
    add_motion(more, island.bodies[m], 1);
    add_motion(more, before[m], -1);
    const double ahead = 2 * island.gravity[m].ahead * (1 / before[m].inverse_mass);
    more.add(ahead * (g.x * before[m].velocity.x));
    more.add(ahead * (g.y * before[m].velocity.y));
  }
  return more.rounded();
}

double SteppedEnergy::given_back(const IslandMotion& island, const std::vector<ConeBody>& before,
                                 const SteppedFlight& next) const {
  const Vec<double>& g = rules_.pull;
  const double now = next.ahead(0);
  ExactSum<double> more;
  for (std::size_t m = 0; m < before.size(); ++m) {
    const double was = island.gravity[m].ahead;
    const double most = dot(g, g) * (was - now) * (was + now);
    if (island.support[m] != kStepped || !(most > 0)) continue;
    const Vec<double> change = island.bodies[m].velocity - before[m].velocity;
    const double made = -(was + now) * (g.x * change.x + g.y * change.y);
    more.add(std::clamp(made, 0.0, most) / before[m].inverse_mass);
  }
  return more.rounded();
}

void SteppedEnergy::leave_out(IslandMotion& island, const std::vector<ConeBody>& before,
                              const SteppedFlight& next) const {
  if (island.left_out.empty()) return;
  for (std::size_t m = 0; m < before.size(); ++m) {
    island.left_out[m] = 0;
    if (island.support[m] != kStepped) continue;
    if (!(next.given() > 0)) continue;
    const double part = next.given() / (island.gravity[m].owed + next.given());
    const Vec<double> made = part * (island.bodies[m].velocity - before[m].velocity);
    island.left_out[m] = dot(made, made) / before[m].inverse_mass / 2;
  }
}

double SteppedEnergy::loss(const IslandMotion& island, double had,
                           const SteppedFlight& next) const {
  // What was lifted onto a wall has that much more, which nothing took.
  return (had - of(island, next).all()) / 2 - island.lifted;
}

double SteppedEnergy::hold(IslandMotion& island, double lost) const {
  if (island.left_out.empty() || lost == 0) return lost;
  if (is_held(island, lost)) {
    std::replace(island.support.begin(), island.support.end(), kResting, kStepped);
  }
  ExactSum<double> mass;
  for (std::size_t m = 0; m < island.bodies.size(); ++m) {
    if (island.support[m] == kStepped) mass.add(1 / island.bodies[m].inverse_mass);
  }
  if (!(mass.rounded() > 0)) return lost;
  ExactSum<double> left;
  left.add(lost);
  for (std::size_t m = 0; m < island.bodies.size(); ++m) {
    if (island.support[m] != kStepped) continue;
    double& energy = island.left_out[m];
    const double was = energy;
    energy += lost / island.bodies[m].inverse_mass / mass.rounded();
    left.add(was);
    left.add(-energy);
  }
  return left.rounded();
}

auto SteppedEnergy::drift_of(const IslandMotion& island, const SteppedFlight& next) const -> Drift {
  const OpenAxes open = rules_.drifts ? open_axes(island) : OpenAxes{false, false};
  if (!open.x && !open.y) return {};
  ExactSum<double> mass;
  ExactSum<double> x;
  ExactSum<double> y;
  for (std::size_t m = 0; m < island.bodies.size(); ++m) {
    if (island.support[m] != kStepped) continue;
    const ConeBody& body = island.bodies[m];
    mass.add(1 / body.inverse_mass);
    x.add(body.velocity.x / body.inverse_mass);
    y.add(body.velocity.y / body.inverse_mass);
  }
  const double all = mass.rounded();
  if (!(all > 0)) return {};
  const Vec<double>& g = rules_.pull;
  const Vec<double> u = open.along({x.rounded() / all, y.rounded() / all});
  return {u, all * (dot(u, u) - 2 * next.ahead(0) * dot(g, u)),
          kDrifts * all * dot(g, g) * (next.seconds * next.seconds)};
}

bool SteppedEnergy::slow_down(IslandMotion& island, double had, const SteppedFlight& next) const {
  const Parts now = of(island, next);
  if (!(now.all() > had) || !(now.stepped > 0)) return false;
  Drift drift = drift_of(island, next);
  const double rounding = kRounded * (now.stepped + std::abs(now.ahead) + now.others);
  if (drift.energy > had - now.others + drift.most + rounding) drift = {};
  IslandMotion seen = island;
  for (ConeBody& body : seen.bodies) body.velocity = body.velocity - drift.velocity;
  const Parts rest = of(seen, next);
  const double a =
      std::max(factors(rest.stepped, rest.ahead, had - now.others - drift.energy).larger, 0.0);
  if (!(a < 1)) return false;
  for (std::size_t m = 0; m < island.bodies.size(); ++m) {
    if (island.support[m] != kStepped) continue;
    ConeBody& body = island.bodies[m];
    body.velocity = drift.velocity + a * seen.bodies[m].velocity;
    body.turning = a * body.turning;
  }
  return true;
}

bool SteppedEnergy::keep(IslandMotion& island, double had, const SteppedFlight& next,
                         bool gives_up) const {
  if (!rules_.keeps) return slow_down(island, had, next);
  Parts now = of(island, next);
  had -= 2 * island.lifted;
  const double moving = now.stepped + now.others;
  if ((gives_up && !(now.all() > had)) || !(moving > 0)) return false;
  if (moving < std::numeric_limits<double>::epsilon() * (had - now.left_out)) return false;
  double a = factor(island, now, had, next);
  if (a < kLeast && now.left_out > 0) {
    // There is not so much: the flights are counted with more.
    const double part = std::clamp((had - now.all()) / now.left_out + 1, 0.0, 1.0);
    for (double& energy : island.left_out) energy *= part;
    now = of(island, next);
    a = part > 0 ? 1 : factor(island, now, had, next);
  }
  if (a == 1) return false;
  for (ConeBody& body : island.bodies) {
    body.velocity = a * body.velocity;
    body.turning = a * body.turning;
  }
  return true;
}

// The larger factor, or the one next to 1 if both are positive.
double SteppedEnergy::factor(const IslandMotion& island, const Parts& now, double had,
                             const SteppedFlight& next) const {
  const Factors both = factors(now.stepped + now.others, now.ahead, had - now.left_out);
  double a = both.larger;
  const bool nearer = std::abs(both.smaller - 1) < std::abs(a - 1);
  // What begins to slide goes faster than gravity makes it; what is only pressed does not.
  if (nearer && (both.smaller > 0 || (a > kStarts && !can_go(island, a, next.way())))) {
    a = both.smaller;
  }
  return std::max(a, 0.0);
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
