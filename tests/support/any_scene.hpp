#pragma once

#include <cstdint>

#include "carom/scene.hpp"

namespace carom::test {

/// Simulated seconds of a scene of `any_scene`.
inline constexpr double kAnySceneTime = 1.5;

/// A random scene, the same for a seed on every machine.  64 seeds in a row have each set of
/// effects once; the next 64 have them with the other method.
///
/// Balls lie in the cells of a grid, on a lattice of 1/8 or anywhere in their cells; some are
/// fixed, some scenes are mixtures.  Any axis may be periodic, the origin may be the centre, method
/// event may have 34 digits.  The script adds, removes, sets, pauses, resumes and quits.  A line
/// that adds a ball may be refused when its time comes.
Scene any_scene(std::uint64_t seed);

}  // namespace carom::test
