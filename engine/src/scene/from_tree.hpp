#pragma once

#include <cstddef>
#include <vector>

#include "carom/scene.hpp"
#include "scene/json_tree.hpp"

namespace carom::scene {

/// A scene as its file says it, before it is judged.
struct Draft {
  Scene scene;
  std::vector<std::size_t>
      script_lines;  ///< of each line of the sorted script: its number in the file
};

/// Takes what has the right type from the tree; in place of a number that has not, a NaN, which
/// every later check passes over.
Draft draft_from_tree(const Value& root);

}  // namespace carom::scene
