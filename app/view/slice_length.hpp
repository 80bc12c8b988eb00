#pragma once

namespace carom {

/// How short a slice of a frame is worth computing.
///
/// A call of the simulation costs something however short its slice is: with a thousand workers
/// that all meet at barriers, more than a frame's time.  Where one slice alone takes longer than
/// there is time, the next one is twice as long, and stays so where it costs hardly more.
///
/// Units: simulated seconds for slices, real ones for costs.
class SliceLength {
 public:
  /// The shortest slice; 0: no limit.
  [[nodiscard]] double shortest() const { return shortest_; }

  /// A slice took `cost`; there was `time` for the whole frame.
  void note(double slice, double cost, double time) {
    const bool longer = last_ > 0 && slice > kLonger * last_;
    if (longer && cost > kHardlyMore * last_cost_) {
      shortest_ = 0;
      patience_ = kPatience;
    } else if (longer) {
      shortest_ = slice;
    } else if (patience_ > 0) {
      --patience_;
    } else if (cost > time) {
      shortest_ = 2 * slice;
    }
    last_ = slice;
    last_cost_ = cost;
  }

 private:
  static constexpr double kLonger = 1.9;
  static constexpr double kHardlyMore = 1.5;
  static constexpr int kPatience = 50;  // slices until it is tried again

  double shortest_ = 0;
  double last_ = 0;
  double last_cost_ = 0;
  int patience_ = 0;
};

}  // namespace carom
