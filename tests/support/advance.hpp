#pragma once

#include <cstddef>
#include <vector>

#include "solvers/solver.hpp"

namespace carom::test {

/// Lets a solver go on to a time, in all phases it asks for, with one worker.
inline void advance(Solver& solver, double time) {
  const std::vector<Phase> phases = solver.phases();
  std::size_t phase = solver.aim(time);
  while (phase != Phase::kFrameDone) {
    phases[phase].work(Share{0, 1});
    phase = phases[phase].finish();
  }
}

}  // namespace carom::test
