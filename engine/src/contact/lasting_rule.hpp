#pragma once

#include <array>

#include "contact/island.hpp"
#include "contact/lasting_island.hpp"

namespace carom::contact {

/// What contacts that last depend on beside the balls.
struct LastingRule {
  double step = 0;
  Vec2 acceleration{0, 0};
  double attraction = 0;             ///< the strongest pull on a ball at the start of the step
  std::array<double, 2> fall{0, 0};  ///< how far a ball at rest flies in a step, by axis
  std::array<double, 2> gain{0, 0};  ///< and how fast it is then
  double restitution = 1;
  double wall_restitution = 1;
  double friction = 0;
  double wall_friction = 0;
  bool loses = false;         ///< impacts do, so that balls come to rest
  double fading = 1;          ///< see IslandStep::Rule
  bool keeps_energy = false;  ///< see IslandStep::Rule

  /// A scale of accelerations.
  [[nodiscard]] double strongest() const { return acceleration.norm() + attraction; }

  /// What a step of an island takes of it, in the island's frame.
  [[nodiscard]] IslandStep::Rule in(const Frame& frame) const {
    IslandStep::Rule rule;
    rule.step = step;
    rule.acceleration = frame.into(acceleration);
    rule.rest_speed = loses ? 2 * strongest() * step : 0;
    rule.speed = strongest() * step;
    rule.fading = fading;
    rule.keeps_energy = keeps_energy;
    return rule;
  }
};

}  // namespace carom::contact
