#pragma once

#include <array>
#include <vector>

#include "solvers/event/ticks.hpp"
#include "state/domain.hpp"

namespace carom::event {

/// Radius and mass, shared by all balls that have the same.
template <class S>
struct BasicKind {
  S radius = 0.5;
  S inverse_mass = 1;  ///< 0: fixed

  [[nodiscard]] bool fixed() const { return inverse_mass == 0; }
};

/// What moves and stops the balls.
template <class S>
struct BasicRules {
  Domain domain;
  Clock<S> scale;
  std::array<double, 2> gravity{0, 0};
  bool collisions = true;
  double restitution = 1;
  double wall_restitution = 1;
  std::vector<BasicKind<S>> kinds{BasicKind<S>{}};
  double drag_rate = 0;
};

using Kind = BasicKind<double>;
using Rules = BasicRules<double>;

}  // namespace carom::event
