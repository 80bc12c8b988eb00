#pragma once

#include <cstddef>

#include "carom/scene_file.hpp"

namespace carom::scene {

/// A problem and where in the text it was met, so that problems can be told in the text's order.
struct Finding {
  std::size_t offset = 0;
  Problem problem;
};

}  // namespace carom::scene
