#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "state/balls.hpp"

namespace carom {

/// How often each ball has gone round a periodic axis: upwards counts up.  Empty where it is not
/// needed.
using Turns = std::array<std::vector<std::int64_t>, 2>;

/// Kinetic energy of the balls that move, and their potential energy in a uniform field.
/// Sums run in ball order.
double kinetic_energy(const Balls& balls);
/// Of uniform disks, m r^2 w^2 / 4; there must be a column of spins.
double spin_energy(const Balls& balls);
double potential_energy(const Balls& balls, const Vec2& gravity, const Vec2& periods,
                        const Turns& turns);
Vec2 momentum(const Balls& balls);

/// Sixteen hexadecimal digits over the exact bits of positions, velocities and, where there are
/// any, spins in ball order.
std::string state_hash(const Balls& balls);

}  // namespace carom
