#pragma once

#include <deque>
#include <vector>

#include "carom/frame.hpp"
#include "view/canvas.hpp"
#include "view/paint.hpp"

namespace carom {

/// Where the balls of the last frames were.
///
/// Memory: a position for each ball in each of the last kFrames frames.
class Trails {
 public:
  static constexpr std::size_t kFrames = 30;

  [[nodiscard]] bool shown() const { return shown_; }
  void show(bool shown);
  /// A frame was computed.  Where balls were added or removed, or time went back, the trails begin
  /// again.
  void add(const Frame& frame);
  /// Draws the ways of the balls where the picture is empty: lines of faint dots.
  void paint(const Frame& frame, Canvas& canvas, const Drawing& drawing) const;

 private:
  bool shown_ = false;
  double time_ = 0;
  std::deque<std::vector<Vec2>> positions_;  // frame by frame, the oldest first
};

}  // namespace carom
