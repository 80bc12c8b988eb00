#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "carom/ball.hpp"
#include "view/canvas.hpp"
#include "view/glyphs.hpp"

namespace carom {

/// What is told of a selected ball.
struct SelectedBall {
  std::size_t number = 0;
  Ball ball;
  bool spins = false;     ///< balls have a spin in this scene
  bool followed = false;  ///< the view goes with it
  std::string next;       ///< its next event, in words
  std::string worker;     ///< who computes it, in words
};

/// The panel of the selected ball; below, words that a click presses.
Canvas selection_panel(const SelectedBall& selected, int columns, int rows, Glyphs glyphs);

/// The key of the word at a cell of the panel; nothing where there is none.
std::optional<int> selection_key_at(const SelectedBall& selected, int columns, int rows, int column,
                                    int row);

}  // namespace carom
