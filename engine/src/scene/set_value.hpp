#pragma once

#include <string>
#include <string_view>

#include "carom/scene_change.hpp"

namespace carom::scene {

/// Sets one value in a well-formed JSON text: the value that is there is replaced, a member that
/// is not there is added, with the objects around it; in a list the index after the last one, or
/// "-", appends.
/// Errors: SceneError with the place where the pointer leads nowhere.
std::string set_value(std::string_view text, const SceneChange& change);

}  // namespace carom::scene
