#pragma once

#include <vector>

#include "scene/json_tree.hpp"

namespace carom::scene {

/// What is wrong with the shape of a scene: unknown and missing keys, values of a wrong type.
/// What the values mean together is `find_problems`' to judge.
std::vector<Finding> find_shape_problems(const Value& root);

}  // namespace carom::scene
