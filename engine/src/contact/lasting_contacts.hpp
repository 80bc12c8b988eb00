#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/impact_log.hpp"
#include "contact/lasting_islands.hpp"
#include "contact/lasting_rule.hpp"
#include "contact/lasting_step.hpp"
#include "contact/pair_list.hpp"
#include "contact/sleepers.hpp"
#include "contact/step_start.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"
#include "state/totals.hpp"

namespace carom::contact {

/// The islands of balls that touch in a step of method `overlap`, and which balls are asleep.
///
/// In each step every ball flies free; balls that then overlap, or are beyond a wall, form islands
/// with all that then touch or nearly do, and an island is solved as a whole from where it was at
/// the start.  Where a solution brings a ball into one that is near but of no or of another island,
/// those are put back, joined and solved again; so what is merely near costs nothing.
/// Balls that stand still and that forces within the friction cones can hold are asleep: they are
/// part of no island, until a ball that is awake comes into one of them.
///
/// Which balls are asleep: sleepers.hpp; how islands are found: lasting_islands.hpp,
/// foreseen_links.hpp; how one is solved: lasting_step.hpp, island.hpp.
///
/// Holds: nothing is remembered beside the balls: what is asleep stands still exactly, and is found
/// asleep again.  No order of balls or pairs changes a bit.
/// Threads: islands of one step are resolved at the same time; the rest by one thread.
class LastingContacts {
 public:
  /// Balls within this part of their reach of each other are near.
  static constexpr double kNear = 0.125;

  struct Count {
    std::uint64_t ball_ball = 0;
    std::uint64_t ball_wall = 0;
    std::uint64_t jammed = 0;
    double deepest = 0;  ///< overlap at the end of the step, by the smaller radius
  };

  LastingContacts(const Domain& domain, const LastingRule& rule, Turns& turns)
      : domain_(domain), rule_(rule), turns_(turns) {}
  LastingContacts(const LastingContacts&) = delete;
  LastingContacts& operator=(const LastingContacts&) = delete;

  /// Something has changed the balls or the rules: all are awake, but those that stand still among
  /// others they are near, `pairs`, and are held.
  void wake_all(const Balls& balls);
  void find_asleep(const Balls& balls, std::span<const Pair> near);
  [[nodiscard]] bool all_asleep() const { return sleepers_.all_asleep(); }
  [[nodiscard]] bool asleep(std::size_t ball) const { return sleepers_.asleep(ball); }

  /// Before a flight: notes where balls [begin, end) start.
  void begin(const Balls& balls, std::size_t begin, std::size_t end);
  /// After it: puts those asleep back, and notes who is beyond a wall.
  void end(Balls& balls, std::size_t begin, std::size_t end, std::vector<std::uint32_t>& out) const;

  /// Finds the islands.  `near`: pairs that are near after the flight, in order.
  void form(Balls& balls, std::span<const Pair> near, std::span<const std::uint32_t> out);
  [[nodiscard]] std::size_t islands() const { return islands_.size(); }
  /// Solves an island, unless that has been done.  May it fall asleep: this is asked at some steps
  /// only.
  void resolve(std::size_t island, Balls& balls, bool may_sleep, IslandStep& step,
               const ImpactLog& log);
  /// The farthest that a ball came to be from where it had flown.
  [[nodiscard]] double farthest_push() const;
  /// Adds the near pairs that overlap now, but are of no island or of two.
  void find_crossing(const Balls& balls, std::span<const Pair> near,
                     std::vector<Pair>& crossing) const;
  /// Whether a ball was driven beyond a wall that was not near.
  [[nodiscard]] bool any_driven() const;
  /// Puts the balls back to where they had flown whose islands are of these pairs, or have been
  /// driven beyond a wall, and finds their islands again, in which these pairs are linked.
  /// `all`: the balls of all islands, and all near pairs are linked.
  void join(Balls& balls, std::span<const Pair> near, std::span<const Pair> crossing, bool all);
  /// Ends a step: counts who has fallen asleep and what happened, and adds what each island has
  /// lost to one of its balls, unless `lost` is empty.
  void settle(std::span<double> lost, Count& count, ImpactLog& log);

 private:
  [[nodiscard]] bool beyond_wall(const Balls& balls, std::size_t ball) const;

  const Domain& domain_;
  const LastingRule& rule_;
  Turns& turns_;
  StepStart start_;
  Sleepers sleepers_{domain_, rule_, start_, turns_};
  LastingIslands islands_{domain_, rule_, start_, sleepers_, turns_};
  LastingStep step_{domain_, rule_, turns_};
};

}  // namespace carom::contact
