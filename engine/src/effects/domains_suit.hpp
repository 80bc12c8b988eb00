#pragma once

#include <array>
#include <cstddef>

#include "carom/effects.hpp"

namespace carom {

/// Whether under these effects many balls can be solved in domains of the plane, each from the
/// flights of its own balls and those around it.
///
/// `periodic`: by axis.  `rests`: contacts may come to rest.
inline bool domains_suit(const Effects& effects, const std::array<bool, 2>& periodic, bool rests) {
  if (!effects.collisions || effects.attraction) return false;
  // Where nothing takes energy, what rests touches from the start.
  if (rests && !effects.drag && !loses_energy(effects)) return false;
  if (!effects.gravity) return true;
  // Domains do not count how often a ball goes round.
  const Vec2& g = effects.gravity->acceleration;
  return !(periodic[0] && g.x() != 0) && !(periodic[1] && g.y() != 0);
}

}  // namespace carom
