#pragma once

#include <vector>

#include "contact/groups.hpp"
#include "contact/pair_list.hpp"
#include "solvers/overlap/pair_search.hpp"
#include "solvers/overlap/step_rules.hpp"

namespace carom::overlap {

/// The groups of a step, resolved in rounds until no ball that was moved far has come to another.
///
/// A light ball between two heavy ones that come together is in one of them after its flight, and
/// in the other once it is moved out: if only one impact of it counted in a step, the heavy ones
/// would never turn round.
///
/// Threads: one thread; groups are resolved between `begin` or `join` and the next call.
class GroupRounds {
 public:
  GroupRounds(const StepRules& rules, PairSearch& pairs) : rules_(rules), pairs_(pairs) {}
  GroupRounds(const GroupRounds&) = delete;
  GroupRounds& operator=(const GroupRounds&) = delete;

  /// A step begins.
  void begin() { rounds_ = 0; }
  /// After all groups are resolved, in which no ball was moved apart by more than `push`: puts into
  /// `touching`, first the pairs that touch after the flight, in order, the groups that have met,
  /// to be resolved again.  False: there are none, or the rounds are used up.
  [[nodiscard]] bool join(std::size_t balls, double push, std::vector<Pair>& touching);
  [[nodiscard]] bool joined() const { return rounds_ > 0; }

 private:
  const StepRules& rules_;
  PairSearch& pairs_;
  Groups groups_;
  std::vector<Pair> known_;  // that have touched in this step
  int rounds_ = 0;
};

}  // namespace carom::overlap
