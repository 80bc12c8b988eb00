#pragma once

#include <cstddef>

namespace carom::event {

/// Whether the balls near each other are one conflict group from the start of a window, met or not.
///
/// A heap that balls fall on is solved again for each ball that is found to meet a path that has
/// changed.  Where the last windows solved much of the balls again for that, all that come near
/// each other are joined before anything is solved, and are solved once.
///
/// Holds: it decides what a run costs, not what comes out.
class MergeForecast {
 public:
  /// How near two boxes are whose balls are joined, times the radii.
  static constexpr double kReach = 1.25;

  [[nodiscard]] bool joins_near() const { return windows_ > 0; }
  /// So many balls of a group with a contact that lasts are solved again in the present window.
  void add_solved_again(std::size_t balls) { again_ += balls; }
  /// It has ended; so many balls can move.
  void end_window(std::size_t balls) {
    if (windows_ > 0) --windows_;
    if (static_cast<double>(again_) > kMuch * static_cast<double>(balls)) windows_ = kWindows;
    again_ = 0;
  }

 private:
  static constexpr double kMuch = 0.25;
  // So many windows later it is seen whether groups would still merge.
  static constexpr int kWindows = 16;

  int windows_ = 0;
  std::size_t again_ = 0;
};

}  // namespace carom::event
