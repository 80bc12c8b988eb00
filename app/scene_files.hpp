#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace carom {

/// The scenes that come with the program, as names without ".json": "gas", "hard/pi".
std::vector<std::string> scene_names();

/// The file that a SCENE of the command line means: the path if there is such a file, else the
/// installed scene of this name; the path where there is neither.
std::filesystem::path find_scene(const std::string& scene);

}  // namespace carom
