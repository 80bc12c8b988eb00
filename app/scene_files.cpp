#include "scene_files.hpp"

#include <algorithm>
#include <array>
#include <system_error>

namespace carom {
namespace {

namespace fs = std::filesystem;

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

/// Where the scenes are: beside an installed program, in the sources of one that was built there,
/// or where the installation was configured to go.
fs::path scenes_folder() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const bool built_here = program == fs::path(CAROM_BUILD_FOLDER);
  const std::array<fs::path, 3> places{
      built_here ? fs::path(CAROM_SOURCE_SCENES) : program / "../share/carom/scenes",
      program / "../share/carom/scenes", fs::path(CAROM_INSTALLED_SCENES)};
  const auto place = std::find_if(places.begin(), places.end(), is_folder);
  return place == places.end() ? fs::path() : place->lexically_normal();
}

}  // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  const fs::path folder = scenes_folder();
  if (folder.empty()) return names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path name = fs::relative(entry.path(), folder);
    if (name.extension() != ".json" || name.string().ends_with(".schema.json")) continue;
    names.push_back((name.parent_path() / name.stem()).string());
  }
  const auto depth = [](const std::string& name) {
    return std::count(name.begin(), name.end(), '/');
  };
  std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return std::pair(depth(a), a) < std::pair(depth(b), b);
  });
  return names;
}

fs::path find_scene(const std::string& scene) {
  std::error_code ignored;
  const bool is_file = fs::exists(scene, ignored) && !is_folder(scene);
  if (scene == "-" || is_file || !fs::path(scene).is_relative()) return scene;
  const auto names = scene_names();
  if (std::find(names.begin(), names.end(), scene) == names.end()) return scene;
  return scenes_folder() / (scene + ".json");
}

}  // namespace carom
