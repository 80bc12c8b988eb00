#pragma once

#include <vector>

#include "carom/scene.hpp"

namespace carom::accuracy {

/// How far balls are from a static equilibrium: the least |G f - w| / |w| over contact forces f
/// within the friction cones, where w are the weights of the balls that can move and G f is what
/// the forces add up to.  0: they can stay at rest; 1: nothing supports them.
///
/// Contacts are gaps below 1e-3 of the smaller radius, to walls too.  With friction the torques are
/// balanced as well.
/// Units: the scene's; the result has none.
/// Errors: none; without gravity, or without a ball that can move, it is 0.
double equilibrium_residual(const std::vector<Ball>& balls, const Box& box, const Effects& effects);

}  // namespace carom::accuracy
