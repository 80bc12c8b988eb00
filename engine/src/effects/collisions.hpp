#pragma once

#include <cstdint>
#include <span>

#include "carom/effects.hpp"
#include "contact/impact_log.hpp"
#include "contact/pair_list.hpp"
#include "state/domain.hpp"
#include "state/totals.hpp"

namespace carom::effects {

/// What the impacts of balls depend on beside the balls.
struct CollisionRule {
  double restitution = 1;
  double wall_restitution = 1;
  Vec2 acceleration{0, 0};
  double friction = 0;       ///< coefficient between balls
  double wall_friction = 0;  ///< and at walls
  double step = 0;
};

/// How often balls met, and each time where that is asked for.
struct ImpactCount {
  std::uint64_t ball_ball = 0;
  std::uint64_t ball_wall = 0;
  std::uint64_t missed = 0;  ///< balls that touched, and have passed through each other
  bool timed = false;        ///< what friction takes is measured
  double friction_seconds = 0;
  ImpactLog log;
  double lost = 0;  ///< energy, by the group that is being resolved
  double push = 0;  ///< the farthest that a ball was moved apart since this was set to 0
};

/// Gives the balls of one group of touching pairs their new velocities and moves them apart.
///
/// The outcome depends on the group alone.  Every impulse keeps momentum and cannot raise the
/// energy; balls are moved apart by inverse mass, and what that costs against gravity is taken from
/// their motion along it.
///
/// REQUIRES: under gravity nothing is lost in impacts; else contacts last: see
/// contact/lasting_contacts.hpp.
///
/// Threads: groups of one step may be resolved at the same time: no ball is in two of them.
class GroupResolver {
 public:
  GroupResolver(const Domain& domain, const CollisionRule& rule, Turns& turns)
      : domain_(domain), rule_(rule), turns_(turns) {}
  GroupResolver(const GroupResolver&) = delete;
  GroupResolver& operator=(const GroupResolver&) = delete;

  /// Gives the energy that the impacts take.  `again`: some of the pairs were resolved in this step
  /// before, and all of them touch still.
  double resolve(Balls& balls, std::span<const Pair> group, bool again, ImpactCount& count) const;

 private:
  const Domain& domain_;
  const CollisionRule& rule_;
  Turns& turns_;  ///< of each ball round the periodic axes
};

}  // namespace carom::effects
