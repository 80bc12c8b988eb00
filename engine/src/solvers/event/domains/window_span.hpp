#pragma once

#include <cstddef>

#include "solvers/event/fixed_time.hpp"

namespace carom::event {

/// How often a disk of a gas meets another, by Enskog, in a second.
/// Units: of the mean distance of neighbours, the area of a disk's share of the plane is 1.
[[nodiscard]] double collision_rate(double speed, double diameter, double spacing, double packing);

/// How long the next window of domains should be: a ball has some collisions in it; where there are
/// several domains, none goes farther than halos are made for.
///
/// Holds: it decides what a run costs, not what comes out.
class WindowSpan {
 public:
  /// So many collisions a ball are a window; more where one domain is all, which has no halo.
  static constexpr double kCollisions = 2;
  static constexpr double kCollisionsAlone = 8;
  /// Of several domains, whose halos it makes wide: how far the fastest ball may go, in spacings.
  static constexpr double kFarthest = 1.4;

  /// What is known of the balls before the first window.
  struct Gas {
    std::size_t movers = 0;  ///< balls that are not fixed
    double spacing = 1;
    double rate = 0;     ///< collisions of a ball in a second; 0: nothing is known of them
    double fastest = 0;  ///< speed
    double gravity = 0;
    double drag_rate = 0;
  };

  explicit WindowSpan(const FixedTimeClock& clock) : clock_(clock) {}

  /// There is one domain, or there are several.
  void set_alone(bool alone);
  /// No window is longer than `longest`.
  void begin(const Gas& gas, FixedTime longest);

  /// Where a window ends that begins now; one domain alone may look beyond the target.
  [[nodiscard]] FixedTime end(FixedTime now, FixedTime target);
  /// The window that has ended took so long, and in it so many impacts were had by a ball, two for
  /// each pair.
  void learn(double halves, FixedTime took);
  /// In it a ball went so far at most.
  void note_farthest(double distance, FixedTime took);

  /// The collisions of a ball that a window is made for.
  [[nodiscard]] double collisions() const { return alone_ ? kCollisionsAlone : kCollisions; }
  /// How far a ball may go in such a time, from what they did last.
  [[nodiscard]] double farthest(FixedTime span) const { return speed_ * clock_.seconds(span); }
  [[nodiscard]] FixedTime length() const { return length_; }

 private:
  void limit();

  FixedTimeClock clock_;
  Gas gas_;
  bool alone_ = true;
  FixedTime length_ = 1;
  FixedTime longest_ = 1;
  bool full_ = false;  ///< it is not the target that ends the present window
  double speed_ = 0;   ///< how far the balls of a window went, by its time: the farthest
};

}  // namespace carom::event
