#pragma once

#include <cstddef>

#include "view/canvas.hpp"
#include "view/glyphs.hpp"

namespace carom {

/// What a bar of time tells while a session is paused.
struct ScrubBar {
  double first = 0;  ///< simulated seconds
  double now = 0;
  double last = 0;
  std::size_t bytes = 0;  ///< that the way back takes
};

/// The bar as a row of so many columns: from the first moment to the last, with a mark at the
/// present one.
Canvas scrub_bar(const ScrubBar& bar, int columns, Glyphs glyphs);

/// The moment at a column of the row.
double moment_at(const ScrubBar& bar, int columns, int column);

}  // namespace carom
