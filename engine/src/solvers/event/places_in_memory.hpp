#pragma once

#include <cstddef>
#include <vector>

#include "carom/scene.hpp"
#include "solvers/event/disk.hpp"
#include "state/domain.hpp"

namespace carom::event {

inline constexpr std::size_t kManyBalls = 4000;  ///< from here on their order in memory matters

/// Where each ball stands in memory: neighbours in the plane next to each other, where the balls
/// are so many that it matters.  No result depends on it.
std::vector<Index> places_in_memory(const Domain& domain, const std::vector<Ball>& balls);

}  // namespace carom::event
