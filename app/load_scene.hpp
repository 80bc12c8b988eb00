#pragma once

#include <string>

#include "carom/scene.hpp"
#include "options.hpp"

namespace carom {

/// The scene of this name, a file or an installed scene, where the command line's --set, method,
/// step, digits, workers and seed replace
/// what it says.  A name of "-" is standard input.
/// Errors: SceneError; UsageError that quotes the option which the scene cannot take.
Scene load_scene(const std::string& name, const Options& options);

/// The same for the built-in scene.
Scene load_builtin_scene(const Options& options);

}  // namespace carom
