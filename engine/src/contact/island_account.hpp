#pragma once

#include "contact/impact_log.hpp"
#include "contact/lasting_island.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"
#include "state/totals.hpp"

namespace carom::contact {

/// The energy that an island lost in a step: by where and how fast its balls are now, and would be
/// if they had flown free.  What flight itself took, by drag, is booked there; of a ball that was
/// asleep nothing is.  `turns`: as they are counted.
[[nodiscard]] double lost_by(const LastingIsland& island, const Balls& balls, const Domain& domain,
                             const Turns& turns, const Vec2& acceleration);

/// Notes every contact that carried an impulse; what the island lost is shared out by what each
/// took from the motion across it.
void note_contacts(const LastingIsland& island, const Balls& balls, const IslandOutcome& outcome,
                   ImpactLog& log);

/// Notes the balls that were asleep at the start of the step and move now.
void note_woken(const LastingIsland& island, ImpactLog& log);

}  // namespace carom::contact
