#pragma once

#include <filesystem>
#include <string>

#include "carom/scene.hpp"

namespace carom::bits {

/// What a scene ends with after `seconds`, its script obeyed: the state's hash, or "refused" where
/// the method does not take the scene, or "failed" where the run says that it cannot go on.
std::string outcome(const std::filesystem::path& file, Method method, double seconds);

}  // namespace carom::bits
