#pragma once

#include <cstdint>
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

/// Where the walls end the ways of an island's balls.
struct WallEnds {
  std::vector<Vec2> inside;               ///< mean velocities, in its frame, that end inside
  std::vector<std::uint32_t> beyond_far;  ///< balls that went beyond a wall that was not near
  double out = 0;                         ///< the most that any mean velocity was changed
};
[[nodiscard]] WallEnds ends_at_walls(const LastingIsland& island, const std::vector<Vec2>& mean,
                                     double step, const Domain& domain);

}  // namespace carom::contact
