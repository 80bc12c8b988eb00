#pragma once

#include <algorithm>
#include <utility>

namespace carom {

/// What a call of the simulation costs, and how long a slice of a frame it should compute.
///
/// A call costs something however short its slice is: with a thousand workers that meet at
/// barriers, several milliseconds.  So its cost is taken as fixed + rate * slice, a straight line
/// through what the last calls cost, and no slice is so short that most of its cost is fixed.
///
/// Units: simulated seconds for slices, real ones for costs.
class SliceCost {
 public:
  /// The slice to compute next: not more than `left`, which is what the frame still wants; not less
  /// than a step; else as long as may well be done in `time`.
  [[nodiscard]] double slice(double left, double step, double time) const {
    if (longest_ == 0) return std::min(left, step);
    // One call for all that is left costs least.
    if (left <= kGrowth * longest_ && fixed_ + usual_rate() * left <= time) return left;
    if (rate_ == 0) return std::min(left, kGrowth * longest_);
    // Where not even a step fits, a longer slice tells now and then whether it costs any more.
    if (!told_ && fixed_ + rate_ * step > time) return std::min(left, kGrowth * last_);
    const double affordable = (kShare * time - fixed_) / rate_;
    const double worthwhile = std::min(fixed_ / rate_, kGrowth * longest_);
    return std::min(left, std::max({step, affordable, worthwhile}));
  }

  void note(double slice, double cost) {
    weight_ = kMemory * weight_ + 1;
    x_ = kMemory * x_ + slice;
    y_ = kMemory * y_ + cost;
    xx_ = kMemory * xx_ + slice * slice;
    xy_ = kMemory * xy_ + slice * cost;
    const double x = x_ / weight_;
    const double y = y_ / weight_;
    const double variance = xx_ / weight_ - x * x;
    // Slices of one length do not tell what is fixed.
    const bool told_before = std::exchange(told_, variance > kSpread * kSpread * x * x);
    if (told_) {
      const double slope = std::max(0.0, (xy_ / weight_ - x * y) / variance);
      fixed_ = std::max(0.0, y - slope * x);
      if (!told_before) rate_ = slope;
    }
    fixed_ = std::min(fixed_, cost);
    rate_ = std::max(kForgets * rate_, (cost - fixed_) / slice);
    longest_ = std::max(longest_, slice);
    last_ = slice;
  }

 private:
  /// Of the last calls on average, above what is fixed.
  [[nodiscard]] double usual_rate() const { return std::max(0.0, y_ - fixed_ * weight_) / x_; }

  static constexpr double kShare = 0.6;    // of the time: a slice may cost more than is foreseen
  static constexpr double kGrowth = 2;     // of a slice over the longest before
  static constexpr double kMemory = 0.9;   // of older calls, for the line
  static constexpr double kForgets = 0.9;  // a call that took long is remembered for some
  static constexpr double kSpread = 0.05;  // of slices, relative, from which they tell a line

  double weight_ = 0;  // sums over the calls so far
  double x_ = 0;
  double y_ = 0;
  double xx_ = 0;
  double xy_ = 0;
  double fixed_ = 0;
  double rate_ = 0;  // with caution
  double longest_ = 0;
  double last_ = 0;
  bool told_ = false;  // the line is known
};

}  // namespace carom
