#pragma once

#include <vector>

#include "solvers/event/disk.hpp"

namespace carom::event {

/// The flights of balls as they were before the impacts of the present instant.
template <class P>
class FlightsBefore {
 public:
  using S = typename P::Scalar;
  using Time = typename P::Time;
  using At = typename P::At;
  using Disk = typename P::Disk;

  struct Before {
    Index ball;
    Disk disk;
    S spin;
    Index left;  ///< the fixed ball at which it began
    double left_out = 0;
  };

  void clear() { all_.clear(); }
  /// REQUIRES: the ball is not among them.
  void add(const Before& before) { all_.push_back(before); }
  [[nodiscard]] const std::vector<Before>& all() const { return all_; }
  /// Takes out those of balls for which `undone(ball)` holds, and hands each to `restore`.
  template <class Undone, class Restore>
  void take_back(const Undone& undone, const Restore& restore) {
    for (const Before& before : all_) {
      if (undone(before.ball)) restore(before);
    }
    std::erase_if(all_, [&](const Before& before) { return undone(before.ball); });
  }
  /// Counts time from `by` ticks later on.  What began too long ago for that began before all.
  void rebase(At by) {
    const Time oldest = P::Clock::ever() + by;
    for (Before& before : all_) {
      Time& start = before.disk.start;
      start = start > oldest ? Time(start - by) : P::Clock::ever();
    }
  }

 private:
  std::vector<Before> all_;
};

}  // namespace carom::event
