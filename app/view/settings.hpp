#pragma once

#include <string>

#include "view/glyphs.hpp"
#include "view/palette.hpp"
#include "view/scene_picker.hpp"

namespace carom {

/// What a person chooses of how scenes are played; none of it changes where balls go.
struct Settings {
  static constexpr int kSlowest = 1;
  static constexpr int kFastest = 120;

  Glyphs glyphs = Glyphs::ascii;
  int frames_per_second = 30;
  Palette palette{Colors::none, Background::any};  ///< of recordings: that of the terminal
  SceneLibrary scene_library;  ///< the scenes that a key offers; none: there are none
  std::string scene;           ///< the one that is played, as they call it
  std::string folder;          ///< where keys write files; empty: they write none
};

}  // namespace carom
