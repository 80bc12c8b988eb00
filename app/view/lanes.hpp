#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "carom/timeline.hpp"

namespace carom {

/// All workers passed a barrier.
struct Passage {
  std::int64_t at = 0;        ///< the last one arrived
  std::uint32_t barrier = 0;  ///< place in Timeline::barriers
  std::size_t last = 0;       ///< the worker that arrived last; of do_frame none
};

/// A span of one thread.
struct Stretch {
  std::int64_t begin = 0;
  std::int64_t end = 0;
};

/// What the threads did in some calls of `advance_to`, thread by thread: when each computed.  It
/// waited at a barrier in all other time between `begin` and `end`.
///
/// Units: nanoseconds, as in Timeline.
struct Lanes {
  std::int64_t begin = 0;                     ///< the control thread ordered the first frame
  std::int64_t end = 0;                       ///< the last worker was done with the last one
  std::uint32_t frame_done = 0;               ///< its place in Timeline::barriers
  std::vector<Passage> passages;              ///< in the order of time
  std::vector<std::vector<Stretch>> workers;  ///< while each computed, in the order of time

  [[nodiscard]] bool empty() const { return passages.empty(); }
};

/// The lanes of a timeline.  Workers that ended before its last frame are left out.
Lanes lanes_of(const Timeline& timeline);

/// The part of the lanes from `begin` to `end`.
Lanes part_of(const Lanes& lanes, std::int64_t begin, std::int64_t end);

/// Nanoseconds of computing between `begin` and `end`.
double computing_in(const std::vector<Stretch>& lane, double begin, double end);

/// The part of all workers' time that they waited, 0 to 1.
double share_of_waiting(const Lanes& lanes);

/// The worker that arrived last most often at the barriers of phases, the lowest of several; their
/// count where there was no such barrier.
std::size_t most_often_last(const Lanes& lanes);

/// The numbers of the `count` workers that computed longest, the lowest first.
std::vector<std::size_t> busiest(const std::vector<double>& computed, std::size_t count);

}  // namespace carom
