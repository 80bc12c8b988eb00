#pragma once

#include <cstddef>
#include <vector>

#include "carom/impact.hpp"
#include "carom/simulation.hpp"
#include "impact_record.hpp"
#include "solvers/solver.hpp"

namespace carom {

/// The numbers that the balls of a run keep for good, and by these its impacts and commands, where
/// they are noted.
class SimulationRecord {
 public:
  /// The solver must outlive this.
  explicit SimulationRecord(Solver& solver);

  [[nodiscard]] const std::vector<std::size_t>& ids() const { return ids_; }
  /// Fills in the numbers of `bookkeeping`, and goes on from there.
  void save(Bookkeeping& bookkeeping) const;
  void go_on_from(const Bookkeeping& earlier);

  /// Notes impacts and commands from now on, or none any more.
  void record(bool wanted);
  /// Those since the last call; as Simulation::take_impacts.
  [[nodiscard]] std::vector<Impact> take(bool at_the_end);
  /// A command that changes no numbers.
  void note(ImpactKind command, double time) { note({.kind = command}, time); }
  /// Before the solver adds or removes a ball: what has happened has its numbers still.
  void before_change() { collect(true); }
  /// After the solver has added a ball, the last one.
  void added(const Vec2& position, double time);
  /// Before the solver removes a ball.
  void removes(std::size_t ball, double time);

 private:
  void collect(bool of_all);
  void note(Impact command, double time);
  void tell_slides(std::size_t ball);

  Solver& solver_;
  std::vector<std::size_t> ids_;  // of the balls, in their order
  std::size_t next_id_;
  bool wanted_ = false;
  ImpactRecord record_;
};

}  // namespace carom
