#pragma once

#include <string_view>

namespace carom::scene {

/// The text of scenes/break.json, put into the program when it is built.
extern const std::string_view kBuiltin;

}  // namespace carom::scene
