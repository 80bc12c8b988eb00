#pragma once

#include <filesystem>
#include <optional>

#include "view/glyphs.hpp"
#include "view/palette.hpp"

namespace carom {

/// What a person has written down of how scenes are played; absent: the default.
struct StoredSettings {
  std::optional<Glyphs> glyphs;
  std::optional<Background> palette;
  std::optional<int> fps;
  std::optional<bool> mouse;
};

/// $XDG_CONFIG_HOME/carom/config.json, by default under ~/.config; empty where there is no home.
/// Source: XDG Base Directory Specification.
std::filesystem::path settings_file();

/// What the file says; nothing where there is none.
/// Errors: std::runtime_error with the file, the JSON pointer, and what would be right.
StoredSettings read_settings(const std::filesystem::path& file);

/// Writes the glyphs into the file, which keeps what else it says.
/// Errors: std::exception.
void remember_glyphs(const std::filesystem::path& file, Glyphs glyphs);

}  // namespace carom
