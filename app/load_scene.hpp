#pragma once

#include <string>

#include "carom/scene.hpp"
#include "options.hpp"

namespace carom {

/// The scene in `file`, where the command line's method, step, digits, workers and seed replace
/// what it says.  A file of "-" is standard input.
/// Errors: SceneError; UsageError that quotes the option which the scene cannot take.
Scene load_scene(const std::string& file, const Options& options);

/// The same for the built-in scene.
Scene load_builtin_scene(const Options& options);

}  // namespace carom
