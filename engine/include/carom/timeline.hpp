#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace carom {

/// What one thread did between two barriers: it computed, then waited for the others.
///
/// Times are nanoseconds since recording began.
/// Holds: begin <= arrived <= left.
struct TimelineEntry {
  std::int64_t begin = 0;    ///< it began to compute
  std::int64_t arrived = 0;  ///< it arrived at the barrier and began to wait
  std::int64_t left = 0;     ///< it was let through
  std::uint64_t frame = 0;   ///< the number of the frame since recording began, from 0
  std::uint32_t phase = 0;   ///< place of the barrier in Timeline::barriers

  bool operator==(const TimelineEntry&) const = default;
};

/// What the control thread and the workers did in the last frames, entry by entry.
struct Timeline {
  /// do_frame, the barrier of each phase, frame_done.
  std::vector<std::string> barriers;
  /// The control thread, an entry a frame: it ordered the frame (begin), all workers had begun it
  /// (arrived), and it was done (left).
  std::vector<TimelineEntry> control;
  /// Each worker in the order of time, first worker 0.  A wait for the first frame since recording
  /// began, or since the worker was started, is not known and has no entry.
  std::vector<std::vector<TimelineEntry>> workers;
};

}  // namespace carom
