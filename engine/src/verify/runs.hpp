#pragma once

#include <vector>

#include "carom/simulation.hpp"

namespace carom::hard {

/// A ball of radius 0.5 and mass 1 where nothing else is said.
Ball ball(double x, double y, double vx, double vy, double radius = 0.5, double mass = 1);

/// The same box, effects and method with other balls.
Scene with_balls(const Scene& scene, std::vector<Ball> balls);

/// What a run has come to.
struct Outcome {
  std::vector<Ball> balls;
  Measurements measured;
};
Outcome run(const Scene& scene, double time);

/// The largest distance between balls of the same number, in position.
double farthest(const std::vector<Ball>& a, const std::vector<Ball>& b);
/// How many balls differ in any bit of position, velocity or spin.
double different(const std::vector<Ball>& a, const std::vector<Ball>& b);

/// |final - initial| momentum, in parts of the sum of the initial sizes of the balls' momenta.
double momentum_error(const Scene& scene, const Outcome& outcome);
/// |final - initial| energy in parts of the initial one.
double energy_error(const Measurements& measured);

/// Method event for the scene's duration, then with all velocities reversed for as long again: how
/// far the balls end from the start.
double way_back(const Scene& scene);

}  // namespace carom::hard
