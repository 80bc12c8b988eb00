#pragma once

#include <vector>

#include "carom/exact_position.hpp"
#include "carom/scene.hpp"

namespace carom::accuracy {

/// Where the balls are at one instant, to the last digit they are computed in.
using Places = std::vector<ExactPosition>;

/// The largest distance of a ball between the two, the shorter way round periodic axes; infinite
/// where a place is no number.
/// REQUIRES: as many balls.
double largest_distance(const Places& one, const Places& other, const Box& box);

}  // namespace carom::accuracy
