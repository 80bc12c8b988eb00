#include "carom/frame_clock.hpp"

namespace carom {

FrameClock::FrameClock(const Continuation& past) : now_(past.clock), paused_(past.paused) {
  const bool never_paused = past.clock == past.time;
  clock_origin_ = past.clock_origin.value_or(never_paused ? 0 : past.clock);
  time_origin_ = past.time_origin.value_or(never_paused ? 0 : past.time);
}

void FrameClock::save(Continuation& past) const {
  past.clock = now_;
  past.paused = paused_;
  if (paused_ || (clock_origin_ == 0 && time_origin_ == 0)) return;
  past.clock_origin = clock_origin_;
  past.time_origin = time_origin_;
}

}  // namespace carom
