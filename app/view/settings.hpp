#pragma once

#include "view/glyphs.hpp"
#include "view/palette.hpp"

namespace carom {

/// What a person chooses of how scenes are played; none of it changes where balls go.
struct Settings {
  static constexpr int kSlowest = 1;
  static constexpr int kFastest = 120;

  Glyphs glyphs = Glyphs::ascii;
  int frames_per_second = 30;
  Palette palette{Colors::none, Background::any};  ///< of recordings: that of the terminal
};

}  // namespace carom
