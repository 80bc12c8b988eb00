#pragma once

#include <optional>
#include <string>

#include "carom/frame.hpp"
#include "view/canvas.hpp"

namespace carom {

/// The exact run beside one on screen.
struct ExactRun {
  std::string name;
  double milliseconds = 0;
  double distance = 0;  ///< largest of a ball between the two, scene units
  double radius = 0;    ///< the smallest
};

/// What a run on screen costs, and how wrong it is.
struct Price {
  std::string method;       ///< as in "overlap, step 1/240 s"
  double milliseconds = 0;  ///< of computing a frame
  double energy_error = 0;  ///< relative
  double max_overlap = 0;   ///< of the smaller radius
  std::optional<ExactRun> beside;
};

/// Lays the price over the upper right corner of the canvas, as much of it as fits.
void paint_price(const Price& price, Canvas& canvas);

/// Marks where the balls of an exact run are, where the picture is empty.
void paint_ghost(const Frame& frame, Canvas& canvas);

}  // namespace carom
