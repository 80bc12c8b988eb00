#pragma once

#include <cstddef>
#include <vector>

#include "carom/scene.hpp"

namespace carom::event {

/// Memory that method event takes for a scene, in bytes.
struct EventMemory {
  std::size_t flights = 0;     ///< with spins where the scene has friction
  std::size_t neighbours = 0;  ///< estimated, as the others; 0 where balls are solved in domains
  std::size_t queue = 0;       ///< the same
  std::size_t domains = 0;     ///< in which workers solve balls: 0 where they are not
};

/// Of the scene with these balls, solved by so many workers.
EventMemory event_memory(const Scene& scene, const std::vector<Ball>& balls, std::size_t workers);

}  // namespace carom::event
