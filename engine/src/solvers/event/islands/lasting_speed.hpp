#pragma once

#include <cstddef>

#include "contact/cone_island.hpp"
#include "solvers/event/islands/found_island.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

/// Slower than this the two of a near contact may approach in a contact that lasts: what gravity
/// and the turning of its normal make in a step.
template <class P>
[[nodiscard]] typename P::Scalar lasting_speed(const Motion<P>& motion,
                                               const FoundIsland<typename P::Scalar>& island,
                                               std::size_t contact) {
  using S = typename P::Scalar;
  if (is_at_wall(island, contact)) return motion.lasting_speed(S(0), S(1));
  const ConeContact& c = island.contacts[contact];
  const auto& near = island.near[contact];
  Vec<double> v = island.bodies[static_cast<std::size_t>(c.a)].velocity;
  if (c.b != kWall) v = v - island.bodies[static_cast<std::size_t>(c.b)].velocity;
  const S reach = root(S(dot(near.r, near.r)));
  return motion.lasting_speed(S(cross(c.normal, v)), reach);
}

}  // namespace carom::event
