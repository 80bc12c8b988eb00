#pragma once

#include <array>
#include <vector>

#include "carom/scene.hpp"
#include "state/domain.hpp"

namespace carom::event {

/// From the fastest ball, what falling across the box adds, and the speed that the lightest ball
/// gets when all share the energy: the shortest time in which something crosses the box, seconds.
/// 1 where nothing moves.
double crossing_time(const Domain& domain, const Effects& effects, const std::vector<Ball>& balls);

/// 0 where it is no effect.
std::array<double, 2> gravity_of(const Effects& effects);

}  // namespace carom::event
