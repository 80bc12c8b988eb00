#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/lasting_island.hpp"
#include "contact/lasting_rule.hpp"
#include "contact/pair_list.hpp"
#include "contact/step_start.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"
#include "state/totals.hpp"

namespace carom::contact {

/// Which balls are asleep: they do not move in a step, until a ball that is awake comes into one
/// that they lie together with.
///
/// Threads: `begin` and `put_back` for other balls at the same time; the rest by one thread.
class Sleepers {
 public:
  Sleepers(const Domain& domain, const LastingRule& rule, const StepStart& start, Turns& turns)
      : domain_(domain), rule_(rule), start_(start), turns_(turns) {}
  Sleepers(const Sleepers&) = delete;
  Sleepers& operator=(const Sleepers&) = delete;

  /// All balls that are not fixed are awake.
  void wake_all(const Balls& balls);
  /// A step begins for balls [begin, end).
  void begin(std::size_t begin, std::size_t end);
  /// A ball that is asleep has flown with the others: puts it back.
  void put_back(Balls& balls, std::size_t ball) const;
  /// Wakes what a ball that is awake has come into, with all that is near to that, and so on; they
  /// are then where they would have flown.  `near`: the pairs that are near.
  void wake_struck(Balls& balls, std::span<const Pair> near);
  void fall_asleep(const std::vector<LastingIsland::Member>& members);
  void end_step() { awoken_ = 0; }

  [[nodiscard]] bool asleep(std::size_t ball) const { return asleep_[ball] != 0; }
  /// Whether it was asleep at the start of the step, and is not now.
  [[nodiscard]] bool woken(std::size_t ball) const { return woken_[ball] != 0; }
  [[nodiscard]] bool moves(const Balls& balls, std::size_t ball) const {
    return !balls.fixed(ball) && !asleep(ball);
  }
  [[nodiscard]] bool all_asleep() const { return awake_ == 0; }
  /// Appends the balls woken in this step, in order.
  void list_woken(std::vector<std::uint32_t>& balls) const;

 private:
  void wake(Balls& balls, std::uint32_t ball);

  const Domain& domain_;
  const LastingRule& rule_;
  const StepStart& start_;
  Turns& turns_;
  std::vector<char> asleep_;
  std::vector<char> woken_;  // in this step
  std::size_t awake_ = 0;
  std::size_t sleeping_ = 0;
  std::size_t awoken_ = 0;  // how many are woken_
};

}  // namespace carom::contact
