#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "carom/scene.hpp"

namespace carom {

/// A place in the box where a ball of this radius overlaps none of `balls`: a random one, and where
/// the box is crowded the first that a scan of it from the lower left finds.  It follows from the
/// scene's seed and `number`; nothing where there is no room.
std::optional<Vec2> find_free_place(const Scene& scene, const std::vector<Ball>& balls,
                                    double radius, std::uint64_t number);

}  // namespace carom
