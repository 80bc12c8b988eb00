#pragma once

#include <array>
#include <cstddef>

#include "carom/crew.hpp"
#include "effects/friction.hpp"
#include "solvers/overlap/pair_search.hpp"
#include "solvers/overlap/step_rules.hpp"
#include "solvers/overlap/work.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"
#include "state/losses.hpp"
#include "state/totals.hpp"

namespace carom::overlap {

/// The flight of a step: each ball moves free, and walls send it back.
///
/// Where contacts last, walls do not: they are contacts of the islands.
/// Threads: a worker flies its balls, and writes those and its own Work.
class StepFlight {
 public:
  StepFlight(Balls& balls, const Domain& domain, const StepRules& rules,
             contact::LastingContacts& contacts, PairSearch& pairs, Losses& losses, Turns& turns)
      : balls_(balls),
        domain_(domain),
        rules_(rules),
        contacts_(contacts),
        pairs_(pairs),
        losses_(losses),
        turns_(turns) {}
  StepFlight(const StepFlight&) = delete;
  StepFlight& operator=(const StepFlight&) = delete;

  /// Flies a worker's balls.  `timed`: effects are timed in this step; `recording`: impacts are
  /// noted.
  void fly(Share share, bool timed, bool recording, Work& work) const;

 private:
  void fly_block(std::size_t begin, std::size_t end, bool timed, bool recording, Work& work,
                 effects::Struck* struck) const;
  void rub_walls(std::size_t begin, std::size_t end, bool timed, bool recording, Work& work) const;
  void fly_lasting(std::size_t begin, std::size_t end, bool timed, bool recording,
                   Work& work) const;
  void note_walls(std::size_t begin, const effects::FrictionBlock* by_friction, Work& work) const;

  Balls& balls_;
  const Domain& domain_;
  const StepRules& rules_;
  contact::LastingContacts& contacts_;
  PairSearch& pairs_;
  Losses& losses_;
  Turns& turns_;
};

}  // namespace carom::overlap
