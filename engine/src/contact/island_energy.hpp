#pragma once

#include <vector>

#include "contact/island.hpp"

namespace carom::contact {

/// What the energy of an island grows by in a step.
[[nodiscard]] double gain(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule,
                          const IslandOutcome& outcome);

/// What of a gain is rounding.
[[nodiscard]] double rounding_of_gain(const std::vector<IslandBody>& bodies,
                                      const IslandStep::Rule& rule);

/// Goes from the velocities without bounces, `plastic`, as far towards those of the outcome as the
/// energy allows; only where nothing is lost may that be farther than they are.
void hold_energy(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule,
                 const IslandOutcome& plastic, IslandOutcome& outcome);

/// Moves the ways of the balls towards those by the velocities `plastic` at the end, by which
/// nothing is gained, as little as ends a gain; what they have in common along the axes that are
/// `open`, 1, as nothing that never moves can push them that way, stays as it is.
void lose_gain(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule,
               const std::vector<Vec2>& plastic, const Vec2& open, IslandOutcome& outcome);

/// Ends the gain that is left: what solutions are not exact to, and what overlaps that come apart
/// lift.  The balls go less far, and in the end slower; along axes that are `open` they do so
/// relative to their centre of mass.
void end_gain(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule, const Vec2& open,
              IslandOutcome& outcome);

/// The balls go the ways `inside` the walls instead, which hold them: a gain is ended, and where
/// nothing is lost in impacts, a loss is given back to the velocities.
void confine(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule,
             const std::vector<Vec2>& inside, IslandOutcome& outcome);

/// Where nothing is lost in impacts: the balls will be put at the ends of the ways `inside` the
/// walls, which are off their own by no more than solutions are inexact to; what this lifts a ball
/// that is not slow, its speed pays for.
void pay_for_rounding(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule,
                      const std::vector<Vec2>& inside, IslandOutcome& outcome);

}  // namespace carom::contact
