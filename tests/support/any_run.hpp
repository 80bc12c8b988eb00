#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "carom/scene_file.hpp"
#include "support/any_scene.hpp"
#include "support/invariants.hpp"
#include "support/seeds.hpp"

namespace carom::test {

/// Exact balls that lose energy under gravity and collide: some gather so that the run takes
/// minutes of its impacts.  Which do is not told by the scene.
inline bool may_gather(const Scene& scene) {
  const Effects& effects = scene.effects;
  return scene.solver.method == Method::event && effects.collisions && effects.gravity &&
         !effects.attraction && loses_energy(scene);
}

/// Tries the invariants on the scene of every seed; reports each seed that breaks one. `leaves_out`
/// says which scenes are not tried.
inline void try_any_scenes(std::uint64_t first, std::uint64_t last,
                           bool (*leaves_out)(const Scene&) = nullptr) {
  const auto [from, to] = seeds(first, last);
  std::size_t left_out = 0;
  for (std::uint64_t seed = from; seed <= to; ++seed) {
    const Scene scene = any_scene(seed);
    if (leaves_out != nullptr && leaves_out(scene)) {
      ++left_out;
      continue;
    }
    const std::string broken = broken_invariant(scene);
    if (broken.empty()) continue;
    ADD_FAILURE() << "CAROM_SEEDS=" << seed << ": " << broken;
    if (from == to) ADD_FAILURE() << write_scene(scene);
  }
  testing::Test::RecordProperty("left_out", static_cast<int>(left_out));
}

}  // namespace carom::test
