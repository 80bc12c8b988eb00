#pragma once

#include <algorithm>
#include <cmath>

#include "carom/measurements.hpp"
#include "carom/vector.hpp"
#include "solvers/solver.hpp"

namespace carom {

/// What a run began with, and what commands have added to its energy.
class SimulationAccount {
 public:
  explicit SimulationAccount(const Solver& solver)
      : initial_(solver.sums()),
        largest_(std::abs(initial_.energy)),
        dissipated_before_(solver.dissipated()) {}

  /// Around a command: the energy before and after it.
  void command(double before, double after) {
    input_ += after - before;
    largest_ = std::max({largest_, std::abs(before), std::abs(after)});
  }
  void measure(const Solver& solver, Measurements& result) const {
    const Solver::Sums final = solver.sums();
    result.energy_initial = initial_.energy;
    result.energy_final = final.energy;
    result.energy_input = input_;
    result.energy_dissipated = std::max(0.0, solver.dissipated() - dissipated_before_);
    result.energy_largest = largest_;
    result.momentum_initial = initial_.momentum;
    result.momentum_final = final.momentum;
  }
  /// By commands.
  [[nodiscard]] double input() const { return input_; }
  /// Goes on from an earlier part of the run, whose losses the solver has taken over.
  void go_on_from(double input) {
    dissipated_before_ = 0;
    input_ = input;
    largest_ = 0;  // the energy at which it goes on is no new look
  }

 private:
  Solver::Sums initial_;
  double largest_;
  double dissipated_before_;
  double input_ = 0;
};

}  // namespace carom
