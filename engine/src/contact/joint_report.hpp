#pragma once

#include <cstddef>

namespace carom::event {

/// What resolving one instant took.
struct JointReport {
  int rounds = 0;    ///< generalised reflections
  int impacts = 0;   ///< contacts of balls that carried an impulse in them, counted every time
  int walls = 0;     ///< the same with walls
  int settling = 0;  ///< rounds for approaches that are rounding only
  int locked = 0;    ///< bodies that had to be given a common velocity: the last resort
  int jammed =
      0;  ///< contacts without a gap, with speed across it that no sequence of impacts ends
  /// Energy of jammed groups that nothing of theirs can move with: it counts as lost.
  double held_energy = 0;
  double lost = 0;  ///< energy that restitution took; what only mends rounding is not counted
};

/// The normal impulse of a contact in one reflection.
template <class S>
struct Stroke {
  std::size_t contact;
  S impulse;
  S approach;  ///< the speed before it
  S restitution;
};

}  // namespace carom::event
