#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "carom/scene.hpp"
#include "solvers/event/core.hpp"

namespace carom::event {

/// The core for the flights and the digits that a start asks for.
std::unique_ptr<Core> make_core(CoreStart start, int digits);

/// Whether contacts of the scene can come to rest: from the start; its script tells what is set
/// while it runs.
bool may_rest(const Scene& scene, const std::vector<Ball>& balls);

/// Memory that one ball takes.
struct BallBytes {
  std::size_t flight = 0;      ///< with its spin where the scene has friction
  std::size_t neighbours = 0;  ///< estimated, as the next one
  std::size_t queue = 0;
};
BallBytes ball_bytes(const Scene& scene);

}  // namespace carom::event
