#pragma once

#include "carom/scene.hpp"

namespace carom {

/// The clock of frames and scripts, which runs on while paused, and the simulated time it stands
/// for.
///
/// Simulated time is time_origin + (clock - clock_origin), both taken when the last pause ended, so
/// that it depends on no frame rate.  What a script says is at times of this clock.
/// Units: seconds.
class FrameClock {
 public:
  FrameClock() = default;
  /// As it stood when a run was saved.
  explicit FrameClock(const Continuation& past);

  [[nodiscard]] double now() const { return now_; }
  [[nodiscard]] bool paused() const { return paused_; }
  /// The simulated time of now, unless paused.
  [[nodiscard]] double time() const { return time_origin_ + (now_ - clock_origin_); }
  /// The frame clock at a simulated time, if no pause comes before.
  [[nodiscard]] double at(double time) const { return clock_origin_ + (time - time_origin_); }

  void move_to(double clock) { now_ = clock; }
  void pause() { paused_ = true; }
  /// The pause, if there is one, ends at this simulated time.
  void resume(double time) {
    if (paused_) start_at(time);
    paused_ = false;
  }
  /// From now on simulated time runs from this one.
  void start_at(double time) {
    clock_origin_ = now_;
    time_origin_ = time;
  }

  /// Writes how it stands now, for the constructor to read.
  void save(Continuation& past) const;

 private:
  double now_ = 0;
  double clock_origin_ = 0;
  double time_origin_ = 0;
  bool paused_ = false;
};

}  // namespace carom
