#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "view/canvas.hpp"
#include "view/glyphs.hpp"
#include "view/lanes.hpp"

namespace carom {

/// What the threads' panel shows.
struct ThreadsView {
  Lanes lanes;
  std::vector<std::string> barriers;  ///< as in Timeline
  std::vector<double> computed;       ///< of late by each worker: the busiest have a lane
  std::int64_t until = 0;             ///< what comes later has not happened yet
  std::string title;
  std::string now;  ///< what is guaranteed now; empty: nothing to say
};

/// Rows of a panel beside the lanes of workers, and those of what is explained.
inline constexpr int kRowsBesideLanes = 6;
inline constexpr int kRowsOfWords = 3;

/// The panel, exactly `columns` by `rows`: a lane for each thread with time from left to right, a
/// mark where all passed a barrier, and how large a part of the time was waiting.
Canvas threads_panel(const ThreadsView& view, int columns, int rows, Glyphs glyphs);

}  // namespace carom
