#pragma once

#include "solvers/event/fixed_time.hpp"

namespace carom::event {

/// When contact islands are stepped: at whole multiples of a power of two of ticks, and only while
/// there is something to step.
///
/// Holds: impacts of the very moment of a step come before it: it is made once at most.
template <class Clock>
class StepClock {
 public:
  using Time = typename Clock::Time;
  using At = typename Clock::At;

  /// Nothing is to be stepped, and nothing is at this moment any more.
  void reset(At now) {
    next_ = Clock::never();
    last_ = now;
  }
  /// Something is to be stepped, every 2^shift ticks: the next step is at `now`, or after it.
  void start(At now, int shift) {
    if (next_ != Clock::never()) return;
    next_ = Clock::span(Clock::steps(now, shift), shift);
    if (next_ < now || !(last_ < now)) next_ = Clock::span(Clock::steps(now, shift) + 1, shift);
  }
  /// never(): nothing is to be stepped.
  [[nodiscard]] const Time& next() const { return next_; }
  [[nodiscard]] bool runs() const { return next_ != Clock::never(); }
  /// The step is made now.
  /// REQUIRES: runs().
  void take() {
    last_ = next_;
    next_ = Clock::never();
  }
  /// Counts time from `by` ticks later on.
  void rebase(At by) {
    if (next_ != Clock::never()) next_ -= by;
    // Of an earlier epoch it is only known that it was earlier: its ticks do not fit into a number.
    last_ = last_ >= by ? Time(last_ - by) : Time(-1);
  }

 private:
  Time next_ = Clock::never();
  Time last_ = 0;  ///< when the last step was, or the balls were taken
};

}  // namespace carom::event
