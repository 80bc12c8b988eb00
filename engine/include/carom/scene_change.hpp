#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "carom/scene.hpp"

namespace carom {

/// One value that replaces what a scene's file says, before the scene is checked.
struct SceneChange {
  std::string pointer;  ///< a JSON pointer (RFC 6901), as in "/effects/drag/rate"
  std::string value;    ///< JSON
};

/// A change from the form "/POINTER=VALUE"; a VALUE that is a bare word is a text.
/// Errors: std::invalid_argument that says what the value is not.
SceneChange parse_change(std::string_view text);

/// As the functions of the same name in scene_file.hpp, with changes.
/// Errors: SceneError, also where a pointer leads nowhere.
Scene read_scene(const std::filesystem::path& file, std::span<const SceneChange> changes);
Scene parse_scene(std::string_view text, const std::string& source,
                  std::span<const SceneChange> changes);
Scene builtin_scene(std::span<const SceneChange> changes);

}  // namespace carom
