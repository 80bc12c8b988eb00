#pragma once

#include <vector>

#include "carom/scene.hpp"
#include "carom/scene_file.hpp"

namespace carom::scene {

/// What the scene names and this method cannot do; empty: it can be computed with it.
std::vector<Problem> find_unavailable(const Scene& scene, Method method);

}  // namespace carom::scene
