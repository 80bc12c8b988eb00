#pragma once

#include <vector>

#include "contact/lasting_island.hpp"
#include "state/domain.hpp"

namespace carom::contact {

/// What a contact with a wall does.
struct WallContactRule {
  double restitution = 1;
  double friction = 0;
};

/// Walls within this part of a radius are near.
constexpr double kNearWall = 0.25;

/// Adds the contacts with the walls that are near at the start or after the flight; of balls that
/// are `driven`, with all walls.
void add_wall_contacts(LastingIsland& island, const Domain& domain, const WallContactRule& rule,
                       const std::vector<char>& driven);

/// Whether the place is beyond a wall that was not near.
[[nodiscard]] bool beyond_far_wall(const LastingIsland::Member& member, const Vec2& place,
                                   const Domain& domain);

}  // namespace carom::contact
