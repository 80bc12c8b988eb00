#pragma once

#include <cstdint>

#include "view/user_interface.hpp"

namespace carom {

/// The times at which frames are due: whole periods from a start, so that no lateness adds up.
class FrameTimer {
 public:
  using Period = std::chrono::nanoseconds;

  FrameTimer(Period period, Instant start) : period_(period), due_(start) {}

  [[nodiscard]] Period period() const { return period_; }
  /// When the next frame is due.
  [[nodiscard]] Instant due() const { return due_; }
  /// The frame that was due is on screen at `now`.  Each later frame whose time has passed by then
  /// is given up and counted as late.
  void shown(Instant now);
  /// Counts from `now`: time has passed in which no frame was wanted.
  void restart(Instant now) { due_ = now; }
  [[nodiscard]] std::uint64_t late() const { return late_; }

 private:
  Period period_;
  Instant due_;
  std::uint64_t late_ = 0;
};

}  // namespace carom
