#pragma once

#include <algorithm>
#include <cstddef>

#include "solvers/event/groups/spacing.hpp"

namespace carom::event {

/// How long the next window should be: shorter after one that was costly, longer after one that was
/// not, near a part of the time in which a ball meets another.
///
/// Holds: it decides what a run costs, not what comes out.
template <class P>
class WindowLength {
 public:
  using S = typename P::Scalar;
  using Time = typename P::Time;
  using At = typename P::At;

  /// What one window took.
  struct Cost {
    std::size_t passes = 0;  ///< over the pairs
    std::size_t solved = 0;  ///< balls of all groups that were solved
  };

  /// No window is longer; never(): they are as long as pays.
  void limit(At longest) { longest_ = longest; }
  /// The balls have moved, so that a usual window is another one.
  void measure(const Spacing& spacing, const typename P::Clock& clock) {
    const double speed = spacing.speed;
    const Time most = Time(P::Clock::longest_flight() / 64);
    usual_ = speed > 0 ? clock.ticks(S(kPart * spacing.way() / speed)) : most;
    usual_ = std::min(std::max(usual_, Time(64)), most);
  }
  /// The next window is a usual one.
  void start_over() { length_ = usual_; }
  /// Where a window ends that begins now: at the target at the latest.
  [[nodiscard]] Time end(At now, At target) {
    const Time wanted = std::min(length_, longest_);
    full_ = wanted <= target - now;
    return full_ ? Time(now + wanted) : Time(target);
  }
  /// The next window is no longer.
  void shorten_to(At most) { length_ = std::min(length_, Time(most)); }
  /// Learns from the window that has ended.  One that the target has cut short and that was not
  /// costly says nothing.
  void learn(const Cost& cost, std::size_t balls) {
    const bool costly =
        cost.passes > kManyPasses ||
        static_cast<double>(cost.solved) > kManySolved * static_cast<double>(balls) + kFewSolved;
    if (!costly && !full_) return;
    const S wanted = static_cast<S>(length_) * (costly ? kShorter : kLonger);
    const S usual = static_cast<S>(usual_);
    length_ =
        P::Clock::whole(std::min(std::max(wanted, S(usual / kMostTimes)), S(usual * kMostTimes)));
  }

 private:
  // A window is costly where more than so many passes were taken, or balls solved for each ball.
  static constexpr std::size_t kManyPasses = 4;
  static constexpr double kManySolved = 0.6;
  static constexpr double kFewSolved = 64;
  static constexpr double kShorter = 0.7;
  static constexpr double kLonger = 1.15;
  // A usual window, as a part of the time in which a ball meets another; none is so many times
  // longer or shorter than that.
  static constexpr double kPart = 0.2;
  static constexpr double kMostTimes = 32;

  Time length_ = 1;
  Time usual_ = 1;
  Time longest_ = P::Clock::never();
  bool full_ = false;  // it is not the target that ends the present window
};

}  // namespace carom::event
