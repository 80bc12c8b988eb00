#pragma once

#include <array>

#include "contact/dissipation.hpp"
#include "effects/contact_group.hpp"
#include "effects/flight.hpp"

namespace carom::effects {

/// Coulomb friction of uniform disks, I = m r^2 / 2.  With t = (-n_y, n_x), n from ball i to ball
/// j, the slip is u = (v_j - v_i).t - (r_i w_i + r_j w_j); the impulse along t that stops it, -u /
/// (3/m_i + 3/m_j), is cut off at the coefficient times the normal impulse.  A wall has r w = 0,
/// and like a fixed ball 1/m = 0.

/// Rubs two members of a group that have just met: `normal` is the size of their normal impulse.
FrictionChange apply_friction(Member& a, Member& b, const LineOfCentres& line, double normal,
                              double coefficient);

/// Rubs a member at the wall across an axis: `normal` is the impulse by mass towards the outside,
/// and so is what it gives, by mass.
FrictionChange apply_wall_friction(Member& member, std::size_t axis, double normal,
                                   double coefficient);

/// What a block of balls took from the walls across each axis in a step: impulse by mass, towards
/// the outside; 0 where a ball met none.
struct Struck {
  std::array<Flight::Lanes, 2> normal{};
};

/// What friction did to them there.
using FrictionBlock = std::array<std::array<FrictionChange, Flight::kBlock>, 2>;

/// Rubs the balls of a block at the walls they struck; `lost`, of the first of them, adds up the
/// energy that it takes; `rubbed`, if there is one, is told of each across each axis.
void apply_wall_frictions(Balls& balls, std::size_t begin, std::size_t count, const Struck& struck,
                          double coefficient, double* lost, FrictionBlock* by_friction = nullptr);

}  // namespace carom::effects
