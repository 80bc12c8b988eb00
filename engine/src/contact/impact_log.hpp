#pragma once

#include <cstddef>
#include <vector>

#include "carom/impact.hpp"

namespace carom {

/// The impacts that one worker notes.
/// Threads: that worker.
struct ImpactLog {
  bool wanted = false;
  double time = 0;  ///< of what is noted next
  std::vector<Impact> impacts;

  /// Gives what was noted away.
  void move_to(std::vector<Impact>& others) {
    others.insert(others.end(), impacts.begin(), impacts.end());
    impacts.clear();
  }
};

/// The side across an axis, at its lower or its upper end.
inline Side side_of(std::size_t axis, bool upper) {
  if (axis == 0) return upper ? Side::right : Side::left;
  return upper ? Side::top : Side::bottom;
}

}  // namespace carom
