#pragma once

#include <cstdint>
#include <vector>

#include "effects/flight.hpp"
#include "state/domain.hpp"

namespace carom::effects {

/// What a wall needs to know to send a ball back along one axis.
struct WallRule {
  double restitution = 1;
  double acceleration = 0;  ///< along the axis
  double drag_rate = 0;
};

/// An impact at a wall, or a contact that does not bounce, of ball `k` of a flight.
struct WallImpact {
  std::size_t k = 0;
  bool upper = false;
  bool bounces = false;
  double arrival = 0;
  double leaving = 0;
  double impulse = 0;  ///< by mass
};

/// Puts balls that have left the box back on its wall and reflects them.
///
/// A ball meets the wall with the speed that its energy gives it there, v0^2 + 2 a (wall - x0), not
/// with the speed it has gained behind it: moving it back does no work.  Gives the number of
/// impacts.  `struck`, if there is one, is told the impulse by mass of each ball that met a wall,
/// towards the outside: of one that lies there, what it takes to stop it.  `met`, if there is one,
/// is given each in turn.
std::uint64_t walls(Flight& flight, const Domain& domain, const WallRule& rule,
                    double* struck = nullptr, std::vector<WallImpact>* met = nullptr);

}  // namespace carom::effects
