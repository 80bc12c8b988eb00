#pragma once

#include <vector>

#include "carom/scene.hpp"
#include "carom/scene_file.hpp"

namespace carom::scene {

/// What the scene asks for and this version does not do yet.
std::vector<Problem> find_unavailable(const Scene& scene);

}  // namespace carom::scene
