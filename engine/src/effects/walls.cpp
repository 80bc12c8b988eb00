#include "effects/walls.hpp"

#include <algorithm>
#include <cmath>

#include "contact/dissipation.hpp"
#include "effects/drag.hpp"
#include "effects/rest.hpp"

namespace carom::effects {
namespace {

// The speed with which a ball that started at distance `distance` before the wall arrives there;
// `pull` is the acceleration towards the wall.
double arrival_speed(const WallRule& rule, double velocity, double pull, double distance) {
  if (rule.drag_rate > 0) return arrival_under_drag(rule.drag_rate, velocity, pull, distance);
  if (pull == 0) return std::abs(velocity);
  const double square = velocity * velocity + 2 * pull * distance;
  return std::isfinite(square) ? std::sqrt(std::max(square, 0.0)) : std::abs(velocity);
}

}  // namespace

std::uint64_t walls(Flight& flight, const Domain& domain, const WallRule& rule, double* struck,
                    std::vector<WallImpact>* met) {
  std::uint64_t impacts = 0;
  const auto reflect = [&](std::size_t k, double wall, double outwards) {
    // Of a pull, half a step's worth is in the velocity already and half is still to come.
    const double pull = flight.pull == nullptr ? 0 : outwards * flight.pull[k];
    const double half = pull * flight.step / 2;
    const double arrival =
        arrival_speed(rule, outwards * flight.velocity[k] - half,
                      outwards * rule.acceleration + pull, outwards * (wall - flight.position[k]));
    const bool bounces = arrival > rest_speed(pull, flight.step, rule.restitution);
    const double leaving = bounces ? rule.restitution * arrival : 0;
    if (struck != nullptr || met != nullptr) {
      const double stopped = std::max(0.0, outwards * flight.after[k] + half);
      const double normal = bounces ? arrival + leaving : stopped;
      if (struck != nullptr) struck[k] = outwards * normal;
      if (met != nullptr) {
        met->push_back({k, outwards > 0, bounces, arrival, leaving, normal});
      }
    }
    if (flight.lost != nullptr) {
      double lost = lost_to_restitution(arrival, leaving, 1);
      if (rule.drag_rate > 0) {
        // Drag has had its way as far as the wall, not for the whole step.
        const double started = outwards * flight.velocity[k] - half;
        const double fallen =
            (outwards * rule.acceleration + pull) * (outwards * (wall - flight.position[k]));
        lost += (started * started - arrival * arrival) / 2 + fallen -
                flight.glide.drag_loss.along(flight.velocity[k], flight.glide.acceleration);
      }
      flight.lost[k] += flight.mass[k] * lost;
    }
    flight.moved[k] = wall;
    flight.after[k] = -outwards * (leaving + half);
    if (bounces) ++impacts;
  };
  // Few balls are out: whether any of some is costs no branch for each.
  constexpr std::size_t kSome = 32;
  for (std::size_t begin = 0; begin < flight.count; begin += kSome) {
    const std::size_t end = std::min(begin + kSome, flight.count);
    std::int64_t out = 0;
    for (std::size_t k = begin; k < end; ++k) {
      const double low = domain.lower[flight.axis] + flight.radius[k];
      const double high = domain.upper[flight.axis] - flight.radius[k];
      out |= flight.moved[k] < low ? 1 : 0;
      out |= flight.moved[k] > high ? 1 : 0;
    }
    if (out == 0) continue;
    for (std::size_t k = begin; k < end; ++k) {
      if (flight.inverse_mass[k] == 0) continue;
      const double lowest = domain.lowest(flight.axis, flight.radius[k]);
      const double highest = domain.highest(flight.axis, flight.radius[k]);
      if (flight.moved[k] < lowest) reflect(k, lowest, -1);
      if (flight.moved[k] > highest) reflect(k, highest, 1);
    }
  }
  return impacts;
}

}  // namespace carom::effects
