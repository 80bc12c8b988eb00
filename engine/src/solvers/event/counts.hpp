#pragma once

#include <algorithm>
#include <cstdint>

namespace carom::event {

/// What has happened so far.
struct Counts {
  std::uint64_t ball_ball = 0;
  std::uint64_t ball_wall = 0;
  std::uint64_t renewals = 0;       ///< squares left: neighbours listed again
  std::uint64_t predictions = 0;    ///< searches for the next impact of a ball
  std::uint64_t stale = 0;          ///< of them, because its partner had met another
  std::uint64_t joint_impacts = 0;  ///< of several contacts at one instant
  std::uint64_t jammed = 0;         ///< contacts without a gap, with speed across: see JointReport
  std::uint64_t resting_contacts = 0;  ///< came to rest
  std::uint64_t wakes = 0;             ///< islands at rest that were hit
  std::uint64_t steps = 0;             ///< of islands
  double max_overlap = 0;              ///< deepest overlap at an impact / smaller radius

  Counts& operator+=(const Counts& other) {
    ball_ball += other.ball_ball;
    ball_wall += other.ball_wall;
    renewals += other.renewals;
    predictions += other.predictions;
    stale += other.stale;
    joint_impacts += other.joint_impacts;
    jammed += other.jammed;
    resting_contacts += other.resting_contacts;
    wakes += other.wakes;
    steps += other.steps;
    max_overlap = std::max(max_overlap, other.max_overlap);
    return *this;
  }
  /// Impacts that have been counted from `from` to `to`, and then were not.
  void take_back(const Counts& from, const Counts& to) {
    ball_ball -= to.ball_ball - from.ball_ball;
    ball_wall -= to.ball_wall - from.ball_wall;
    joint_impacts -= to.joint_impacts - from.joint_impacts;
    jammed -= to.jammed - from.jammed;
    resting_contacts -= to.resting_contacts - from.resting_contacts;
    wakes -= to.wakes - from.wakes;
  }
};

}  // namespace carom::event
