#include "view/frame_timer.hpp"

namespace carom {

void FrameTimer::shown(Instant now) {
  due_ += period_;
  if (now < due_) return;
  const auto missed = (now - due_) / period_ + 1;
  due_ += missed * period_;
  late_ += static_cast<std::uint64_t>(missed);
}

}  // namespace carom
