#pragma once

#include "carom/effects.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"
#include "state/totals.hpp"

namespace carom::effects {

/// Kinetic energy, with that of spins where there is friction, and the potential energy of gravity
/// and attraction.
[[nodiscard]] double energy(const Balls& balls, const Effects& effects, const Domain& domain,
                            const Turns& turns);

}  // namespace carom::effects
