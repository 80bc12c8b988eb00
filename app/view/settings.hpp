#pragma once

#include "view/glyphs.hpp"

namespace carom {

/// What a person chooses of how scenes are played; none of it changes where balls go.
struct Settings {
  static constexpr int kSlowest = 1;
  static constexpr int kFastest = 120;

  Glyphs glyphs = Glyphs::ascii;
  int frames_per_second = 30;
};

}  // namespace carom
