#pragma once

#include <array>

#include "carom/effects.hpp"
#include "contact/contacts_last.hpp"
#include "contact/lasting_rule.hpp"
#include "effects/collisions.hpp"
#include "effects/flight.hpp"
#include "effects/walls.hpp"
#include "state/balls.hpp"

namespace carom::overlap {

/// What a step takes of the effects: worked out again where one of them, the step or the balls
/// change.
struct StepRules {
  double step = 0;
  double drag_rate = 0;
  double smallest_radius = 0;  ///< of all balls; infinite if there are none
  std::array<Glide, 2> glide;
  std::array<effects::WallRule, 2> wall;
  effects::CollisionRule collision;
  contact::LastingRule lasting;
  bool collides = false;
  bool contacts_last = false;  ///< contacts that last are looked for
  bool sleeps = false;         ///< and balls fall asleep: what pulls them does not change
  bool loses = false;          ///< energy is lost by what the scene names

  StepRules() = default;
  StepRules(const Effects& effects, const Balls& balls, double step);
};

}  // namespace carom::overlap
