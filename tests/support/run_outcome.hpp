#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <utility>

#include "carom/simulation.hpp"
#include "solvers/event/solver.hpp"

namespace carom::test {

/// What a run of method event came to: where all balls are, to the last bit, and what was counted.
struct RunOutcome {
  std::string state_hash;
  std::uint64_t ball_ball = 0;
  std::uint64_t ball_wall = 0;
  std::uint64_t joint_impacts = 0;
  std::uint64_t resting_contacts = 0;
  double max_overlap = 0;
  double dissipated = 0;
  double energy = 0;  ///< 0 where a solver is asked, which does not know it

  bool operator==(const RunOutcome&) const = default;
};

inline std::ostream& operator<<(std::ostream& out, const RunOutcome& o) {
  return out << o.state_hash << ' ' << o.ball_ball << ' ' << o.ball_wall << ' ' << o.joint_impacts
             << ' ' << o.resting_contacts << ' ' << o.max_overlap << ' ' << o.dissipated << ' '
             << o.energy;
}

inline RunOutcome outcome_of(std::string state_hash, const Measurements& measured,
                             double dissipated) {
  return {
      std::move(state_hash),     measured.ball_ball,   measured.ball_wall, measured.joint_impacts,
      measured.resting_contacts, measured.max_overlap, dissipated,         measured.energy_final};
}

inline RunOutcome outcome_of(const EventSolver& solver) {
  Measurements measured;
  solver.count(measured);
  return outcome_of(solver.state_hash(), measured, solver.dissipated());
}

inline RunOutcome outcome_of(const Simulation& simulation) {
  const Measurements measured = simulation.measure();
  return outcome_of(simulation.state_hash(), measured, measured.energy_dissipated);
}

}  // namespace carom::test
