#pragma once

#include <array>
#include <cstddef>

#include "carom/effects.hpp"

namespace carom {

/// Whether under these effects many balls can be solved in domains of the plane, each from the
/// flights of its own balls and those around it.
///
/// `periodic`: by axis.  `fixed`: some balls are.  `rests`: contacts may come to rest.
inline bool domains_suit(const Effects& effects, const std::array<bool, 2>& periodic, bool fixed,
                         bool rests) {
  if (!effects.collisions || effects.attraction) return false;
  const bool loses = loses_energy(effects);
  // Where nothing takes energy, what rests touches from the start.
  if (rests && !loses) return false;
  // On fixed balls nothing may come to rest.
  if (fixed && (effects.drag || (effects.gravity && loses))) return false;
  // What drag takes is known by the time alone where nothing else takes energy.
  if (effects.drag && (effects.gravity || effects.friction || loses)) return false;
  if (!effects.gravity) return true;
  // Domains do not count how often a ball goes round.
  const Vec2& g = effects.gravity->acceleration;
  return !(periodic[0] && g.x() != 0) && !(periodic[1] && g.y() != 0);
}

}  // namespace carom
