#pragma once

#include <vector>

#include "contact/island.hpp"

namespace carom::contact {

/// How far balls at rest are from a static equilibrium: the least |G f - w| / |w| over forces f >=
/// 0 within the friction cones at the contacts, w the weights of the balls; 0 is equilibrium, 1 a
/// ball in the air.
/// REQUIRES: at least one ball, an acceleration that is not 0.
double equilibrium_residual(const std::vector<IslandBody>& bodies,
                            const std::vector<IslandContact>& contacts, bool spins,
                            const Vec2& acceleration);

}  // namespace carom::contact
