#pragma once

#include <vector>

#include "carom/scene.hpp"
#include "solvers/event/core_in_precision.hpp"

namespace carom::event {

/// The core for the flights and the digits that a start asks for.
/// REQUIRES: digits of 16, 34, 50 or 100.
CoreInPrecision make_core(CoreStart start, int digits);

/// Whether contacts of the scene can come to rest: from the start; its script tells what is set
/// while it runs.
bool may_rest(const Scene& scene, const std::vector<Ball>& balls);

}  // namespace carom::event
