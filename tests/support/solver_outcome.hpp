#pragma once

#include <cstdint>
#include <string>

#include "solvers/event/solver.hpp"

namespace carom::test {

/// What a run of method event came to: where all balls are, to the last bit, and what was counted.
struct SolverOutcome {
  std::string state_hash;
  std::uint64_t ball_ball = 0;
  std::uint64_t ball_wall = 0;
  std::uint64_t joint_impacts = 0;
  std::uint64_t resting_contacts = 0;
  double max_overlap = 0;
  double dissipated = 0;

  bool operator==(const SolverOutcome&) const = default;
};

inline SolverOutcome outcome_of(const EventSolver& solver) {
  Measurements measured;
  solver.count(measured);
  return {solver.state_hash(),    measured.ball_ball,        measured.ball_wall,
          measured.joint_impacts, measured.resting_contacts, measured.max_overlap,
          solver.dissipated()};
}

}  // namespace carom::test
