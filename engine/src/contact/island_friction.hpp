#pragma once

#include "contact/island.hpp"

namespace carom::contact {

/// How a surface moves: the velocity of a ball's centre, and its spin times its radius.
struct SurfaceMotion {
  Vec2 velocity{0, 0};
  double turning = 0;
};

/// How fast the second surface slips along (-n_y, n_x) over the first one.
[[nodiscard]] double slip_of(const IslandContact& contact, const SurfaceMotion& a,
                             const SurfaceMotion& b);

/// What friction does along (-n_y, n_x) to a contact alone, by the mass it moves: it stops the
/// slip, or does the most it can.  Of what it does to velocities drag leaves the part `fading`.
[[nodiscard]] double friction_against(double slip, double most, double fading);

}  // namespace carom::contact
