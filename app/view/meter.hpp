#pragma once

#include <deque>
#include <optional>

#include "view/user_interface.hpp"

namespace carom {

/// What the last second of frames says about speed.
class Meter {
 public:
  /// A frame came on screen at `now` that shows simulated time `time` and took `computing` to
  /// compute.
  void record(Instant now, double time, std::chrono::duration<double> computing);
  /// Forgets the past, where it says nothing about what comes.
  void reset() { frames_.clear(); }

  [[nodiscard]] double frames_per_second() const;
  [[nodiscard]] double computing_milliseconds() const;
  /// Simulated seconds per second of real time; absent until there is enough to tell.
  [[nodiscard]] std::optional<double> pace() const;

 private:
  struct Shown {
    Instant at;
    double time = 0;
    std::chrono::duration<double> computing;
  };

  [[nodiscard]] double span() const;

  std::deque<Shown> frames_;
};

}  // namespace carom
