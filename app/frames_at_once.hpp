#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>

namespace carom {

/// How many frames a run advances at once where no frame is written: all, or so many that its
/// progress is shown ten times a second.
class FramesAtOnce {
 public:
  explicit FramesAtOnce(bool shows_progress)
      : frames_(shows_progress ? 1 : std::numeric_limits<std::uint64_t>::max()),
        adapts_(shows_progress) {}

  [[nodiscard]] std::uint64_t frames() const { return frames_; }

  /// After each stretch: twice as many frames if it was quick, fewer if it was slow.
  void adapt() {
    if (!adapts_) return;
    constexpr std::chrono::milliseconds kQuick(30);
    constexpr std::chrono::milliseconds kSlow(100);
    constexpr std::uint64_t kMost = std::uint64_t{1} << 53U;
    const auto now = Clock::now();
    const auto spent = now - began_;
    began_ = now;
    if (spent < kQuick) frames_ = std::min(2 * frames_, kMost);
    if (spent > kSlow) frames_ = std::max<std::uint64_t>(1, frames_ / 2);
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::uint64_t frames_;
  bool adapts_;
  Clock::time_point began_ = Clock::now();
};

}  // namespace carom
