#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "carom/scene_file.hpp"
#include "support/any_scene.hpp"
#include "support/invariants.hpp"
#include "support/seeds.hpp"

namespace carom::test {

/// Tries the invariants on the scene of every seed; reports each seed that breaks one.
inline void try_any_scenes(std::uint64_t first, std::uint64_t last) {
  const auto [from, to] = seeds(first, last);
  std::size_t left_out = 0;
  for (std::uint64_t seed = from; seed <= to; ++seed) {
    const Scene scene = any_scene(seed);
    const Verdict verdict = try_invariants(scene);
    if (!verdict.left_out.empty()) ++left_out;
    if (verdict.broken.empty()) continue;
    ADD_FAILURE() << "CAROM_SEEDS=" << seed << ": " << verdict.broken;
    if (from == to) ADD_FAILURE() << write_scene(scene);
  }
  testing::Test::RecordProperty("left_out", static_cast<int>(left_out));
}

}  // namespace carom::test
