#pragma once

#include <cstdint>
#include <optional>

#include "carom/session.hpp"
#include "options.hpp"

namespace carom {

/// When a headless run has its frames and where it ends.
///
/// Frame k is at k / frame_rate on the frame clock, which a saved scene goes on with.  The end is a
/// simulated time, met exactly, or a number of frames.
/// Errors: UsageError where the end asked for is out of reach of the clock.
class Schedule {
 public:
  enum class End { none, time, frames, script, paused };

  /// Where a run began that goes on here.
  struct Beginning {
    std::uint64_t frame = 0;
    double time = 0;  ///< simulated seconds
  };

  Schedule(Session& session, const Options& options,
           const std::optional<Beginning>& beginning = {});

  /// Moves on to the next frame; false when the run is over, which may be between two frames.
  bool next_frame();
  /// The same over up to `most` frames at once, from line to line of the script: for a run whose
  /// frames are not looked at.
  /// Holds: the run ends as one that stops at every frame, to the last bit.
  bool next_frames(std::uint64_t most);

  [[nodiscard]] std::uint64_t frame() const { return frame_; }  ///< its number on the clock
  [[nodiscard]] std::uint64_t frames() const { return frame_ - first_frame_; }
  [[nodiscard]] Beginning beginning() const { return {first_frame_, start_time_}; }
  [[nodiscard]] End end() const { return end_; }
  [[nodiscard]] double part_done() const;

 private:
  bool over();
  bool move_on(std::uint64_t frame);
  [[nodiscard]] double clock_of(std::uint64_t frame) const;
  [[nodiscard]] std::uint64_t frame_before(double clock) const;
  bool move_clock_to(double clock);
  bool move_until(double clock);

  Session& session_;
  std::uint64_t first_frame_;
  std::uint64_t frame_;
  double start_time_;
  std::optional<double> end_time_;          // simulated; else
  std::optional<std::uint64_t> end_frame_;  // the last one
  End end_ = End::none;
};

/// What the report calls the end: "time", "frames", "script" or "paused".
const char* end_name(Schedule::End end);

}  // namespace carom
