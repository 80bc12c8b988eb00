#pragma once

#include <vector>

#include "contact/impact_log.hpp"
#include "contact/lasting_island.hpp"
#include "contact/lasting_rule.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"
#include "state/totals.hpp"

namespace carom::contact {

/// Takes an island through a step: solves it and moves its balls, or puts them back.
///
/// Threads: any number, each with other islands.
class LastingStep {
 public:
  LastingStep(const Domain& domain, const LastingRule& rule, Turns& turns)
      : domain_(domain), rule_(rule), turns_(turns) {}
  LastingStep(const LastingStep&) = delete;
  LastingStep& operator=(const LastingStep&) = delete;

  /// Solves an island and moves its balls.  One that is slow and that forces can hold falls asleep
  /// where it was at the start, if it `may_sleep`.  `driven`, by ball: set where a ball has gone
  /// beyond a wall that was not near.
  void take(LastingIsland& island, Balls& balls, bool may_sleep, std::vector<char>& driven,
            IslandStep& step, const ImpactLog& log) const;
  /// Puts the balls of an island back to where they had flown.
  void undo(const LastingIsland& island, Balls& balls) const;

 private:
  void keep_inside(LastingIsland& island, const IslandStep::Rule& rule, std::vector<char>& driven,
                   IslandOutcome& outcome) const;
  void move(LastingIsland& island, Balls& balls, const IslandOutcome& outcome) const;
  void put(Balls& balls, LastingIsland::Member& member, const Vec2& place, const Vec2& velocity,
           double spin) const;
  [[nodiscard]] double deepest(const LastingIsland& island, const Balls& balls) const;

  const Domain& domain_;
  const LastingRule& rule_;
  Turns& turns_;
};

}  // namespace carom::contact
