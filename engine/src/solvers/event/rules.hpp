#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "solvers/event/fixed_time.hpp"
#include "state/domain.hpp"

namespace carom::event {

/// Radius and mass, shared by all balls that have the same.
template <class S>
struct BasicSpecies {
  S radius = 0.5;
  S inverse_mass = 1;    ///< 0: fixed
  unsigned support = 0;  ///< the axes along which something carries it: 1 for x, 2 for y

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
  std::vector<BasicSpecies<S>> all_species{BasicSpecies<S>{}};
  double drag_rate = 0;
  double friction = 0;  ///< of balls with each other
  double wall_friction = 0;
  bool falls = false;  ///< gravity is an effect, even where it is 0 at present
  bool spins = false;  ///< balls have friction and so have a spin
  bool rests = false;  ///< contacts can come to rest
  std::size_t movers = std::numeric_limits<std::size_t>::max();  ///< balls that are not fixed

  [[nodiscard]] bool has_friction() const { return friction > 0 || wall_friction > 0; }
  /// Gravity pulls along this axis, which is periodic.
  [[nodiscard]] bool falls_round(std::size_t axis) const {
    return gravity[axis] != 0 && domain.period[axis] > 0;
  }
  /// Drag is all that changes the energy: it takes the same part of every ball's in a time,
  /// whatever its impacts.
  [[nodiscard]] bool only_drag_takes() const {
    return drag_rate > 0 && !falls && !spins && restitution == 1 && wall_restitution == 1;
  }
};

/// Whether energy is lost, so that contacts can come to rest.
template <class S>
bool can_rest(const BasicRules<S>& rules) {
  const bool falls = rules.gravity[0] != 0 || rules.gravity[1] != 0;
  return rules.wall_restitution < 1 || (rules.collisions && rules.restitution < 1) ||
         (falls && (rules.drag_rate > 0 || rules.has_friction()));
}

using Species = BasicSpecies<double>;
using Rules = BasicRules<double>;

}  // namespace carom::event
