#pragma once

#include <cstdint>
#include <vector>

#include "carom/vector.hpp"
#include "view/canvas.hpp"
#include "view/disk.hpp"
#include "view/glyphs.hpp"

namespace carom {

/// Thin lines of dots: two by four in a cell, as braille patterns; with ASCII one or two above each
/// other.
///
/// Units: places among the cells, as of Camera.
class Dots {
 public:
  /// `clip`: the cells in which there may be any.
  Dots(const Canvas& canvas, const CellRange& clip, Glyphs glyphs);

  void line(const Vec2& from, const Vec2& to, float heat);
  /// Puts the dots where the canvas is empty.
  void lay_under(Ink ink, Canvas& canvas) const;

 private:
  void dot(double x, double y, float heat);

  struct Spot {
    std::uint8_t dots = 0;
    float heat = 0;
  };

  int columns_;
  CellRange clip_;
  Glyphs glyphs_;
  std::vector<Spot> spots_;
};

}  // namespace carom
