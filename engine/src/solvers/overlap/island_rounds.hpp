#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/lasting_contacts.hpp"
#include "contact/pair_list.hpp"
#include "effects/flight.hpp"
#include "solvers/overlap/pair_search.hpp"
#include "solvers/overlap/step_rules.hpp"
#include "state/balls.hpp"

namespace carom::overlap {

/// The islands of a step, solved in rounds until none brings together balls that were not looked
/// at; see contact/lasting_contacts.hpp.
///
/// Threads: one thread; islands are resolved between `form` or `join` and the next call.
class IslandRounds {
 public:
  IslandRounds(Balls& balls, const StepRules& rules, PairSearch& pairs,
               contact::LastingContacts& contacts)
      : balls_(balls), rules_(rules), pairs_(pairs), contacts_(contacts) {}
  IslandRounds(const IslandRounds&) = delete;
  IslandRounds& operator=(const IslandRounds&) = delete;

  /// Balls, rules or step have changed: what is asleep is found again by `find_asleep`.
  void forget() { knows_asleep_ = false; }
  /// Finds which balls are asleep, unless that is known.
  void find_asleep();

  /// Finds the islands of a step.  `touching`: pairs that touch after the flight, in order; `out`:
  /// balls beyond a wall.
  void form(std::span<const Pair> touching, std::span<const std::uint32_t> out);
  /// After all islands are resolved: joins those that have met, to be resolved again, and adds to
  /// `touching` what they have met.  False: there are none, or the rounds are used up.
  [[nodiscard]] bool join(std::vector<Pair>& touching);

 private:
  void find_far_overlaps(std::vector<Pair>& touching, std::vector<Pair>& fresh);

  Balls& balls_;
  const StepRules& rules_;
  PairSearch& pairs_;
  contact::LastingContacts& contacts_;
  bool knows_asleep_ = false;
  int rounds_ = 0;  // of this step: how often islands have been joined
};

}  // namespace carom::overlap
