#pragma once

#include <vector>

#include "carom/scene.hpp"

namespace carom::scene {

/// Whether any two of the balls overlap that are not both fixed, or this was not worked out: where
/// most balls are small beside the largest one, a DiskGrid is quicker.  In the sense of
/// `overlap_depth`.
/// REQUIRES: finite positions, radii above 0.
bool may_overlap(const Box& box, const std::vector<Ball>& balls);

}  // namespace carom::scene
