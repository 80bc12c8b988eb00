#pragma once

#include <filesystem>
#include <string>

#include "carom/scene.hpp"

namespace carom::bits {

/// What a scene ends with after `seconds`, its script obeyed: the hash of the state; "refused"
/// where the method does not take the scene; "failed" where the run says that it cannot go on. Each
/// run has a process of its own, so that a crash is an outcome too: "crashed".
std::string outcome(const std::filesystem::path& file, Method method, double seconds);

}  // namespace carom::bits
