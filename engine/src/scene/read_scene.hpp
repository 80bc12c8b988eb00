#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "carom/scene.hpp"
#include "scene/finding.hpp"

namespace carom::scene {

/// A scene as its text says it, before it is judged.
struct Draft {
  Scene scene;
  /// Of each line of the sorted script: its number in the text.
  std::vector<std::size_t> script_lines;
  /// What is wrong with the text itself, or with the shape of the scene: unknown, missing and
  /// second keys, values of a wrong type.  What the values mean together is `judge`'s.
  std::vector<Finding> findings;
  bool complete = false;  ///< it is a JSON object to its end
};

/// Reads a scene by the table of keys, value by value: of what is listed by the million nothing is
/// in memory but the text and the balls.  In place of a number that is missing or none there is a
/// NaN, which every later check passes over.
Draft read_draft(std::string_view text);

/// Where in a JSON text each pointer leads, or the last part of it that is there.
/// REQUIRES: JSON.
std::vector<std::size_t> offsets_of(std::string_view text,
                                    const std::vector<std::string_view>& pointers);

}  // namespace carom::scene
