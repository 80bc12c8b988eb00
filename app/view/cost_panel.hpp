#pragma once

#include <optional>
#include <string>

#include "carom/frame.hpp"
#include "view/paint.hpp"

namespace carom {

/// The reference run beside the one on screen.
struct ReferenceCost {
  std::string name;
  double milliseconds = 0;
  double distance = 0;            ///< largest of a ball between the two, scene units
  double radius = 0;              ///< the smallest
  double span = 0;                ///< simulated time that the two were compared
  std::optional<double> horizon;  ///< until they were apart by a hundredth of the radius
};

/// What a run on screen costs, and how wrong it is.
struct Cost {
  std::string method;       ///< as in "overlap, step 1/240 s"
  std::string precision;    ///< what a horizon is of, as in "double precision", "this step"
  double milliseconds = 0;  ///< of computing a frame
  double dissipated = 0;    ///< energy taken by restitution, friction and drag
  double energy_error = 0;  ///< relative: what nothing accounts for
  double max_overlap = 0;   ///< of the smaller radius
  std::optional<ReferenceCost> reference;
};

/// Its rows in full.
constexpr int rows_of_cost(bool with_reference) {
  return with_reference ? 11 : 7;
}

/// The panel, at most `columns` by `rows`.
Canvas cost_panel(const Cost& cost, int columns, int rows, Glyphs glyphs);

/// Marks where the balls of a reference run are, where the picture is empty.
void paint_reference(const Frame& frame, Canvas& canvas, const Drawing& drawing = {});

}  // namespace carom
