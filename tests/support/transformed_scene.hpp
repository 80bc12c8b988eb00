#pragma once

#include "carom/scene.hpp"
#include "verify/transform.hpp"

namespace carom::test {

/// Powers of two by which lengths, times and masses are multiplied.
struct Units {
  double length = 1;
  double time = 1;
  double mass = 1;
};

/// The whole scene in other units: balls, effects, solver, duration and script.
Scene in_units(const Scene& scene, const Units& units);

/// The whole scene in a mirror through the centre of its box, script and all.
/// REQUIRES: the origin is the centre.
Scene in_mirror(const Scene& scene, hard::Mirror mirror);

/// The scene with its balls in another order, drawn from the seed; the script removes the same
/// ball.
struct Reordered {
  Scene scene;
  /// balls[k] of the scene at its end is ball number[k] of the original at its end.
  std::vector<std::size_t> number;
};
Reordered reordered(const Scene& scene, std::uint64_t seed);

}  // namespace carom::test
