#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "carom/crew.hpp"
#include "carom/exact_position.hpp"
#include "carom/impact.hpp"
#include "carom/measurements.hpp"
#include "carom/scene.hpp"

namespace carom {

/// A method of moving a scene on in time.
///
/// Threads: the control thread calls everything, while no phase runs; the phases run on the crew.
class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver() = default;

  /// What the workers do, in order; called once, before the first frame.
  [[nodiscard]] virtual std::vector<Phase> phases() = 0;
  /// How many workers there are; called before the first frame and whenever that changes.
  virtual void set_workers(std::size_t workers) = 0;
  /// Prepares to move on to `time`: gives the phase to start with, kFrameDone if nothing is due.
  [[nodiscard]] virtual std::size_t aim(double time) = 0;

  virtual void add(const Ball& ball) = 0;
  virtual void remove(std::size_t ball) = 0;
  /// New values for the effects that are named; the others stay.
  virtual void set(const Effects& effects) = 0;
  virtual void set_step(double step) = 0;

  [[nodiscard]] virtual std::size_t balls() const = 0;
  using BallVisitor = std::function<void(const Ball&)>;
  using FlightVisitor = std::function<void(const SavedFlight&)>;
  /// Shows the balls as they are now, one by one in their order.
  virtual void visit_state(const BallVisitor& visit) const = 0;
  [[nodiscard]] std::vector<Ball> state() const {
    std::vector<Ball> result;
    result.reserve(balls());
    visit_state([&result](const Ball& ball) { result.push_back(ball); });
    return result;
  }
  /// Where the balls are to the last digit that is computed; `state` rounds to double.
  [[nodiscard]] virtual std::vector<ExactPosition> exact_positions() const {
    std::vector<ExactPosition> result;
    for (const Ball& ball : state()) result.push_back({{ball.position.x()}, {ball.position.y()}});
    return result;
  }
  [[nodiscard]] virtual std::string state_hash() const = 0;
  /// Kinetic and potential.
  [[nodiscard]] virtual double energy() const = 0;
  /// The energy that restitution, friction and drag have taken so far, each by its own formula.
  [[nodiscard]] virtual double dissipated() const = 0;
  /// What it is summed up from, and going on from that: later sums are the same to the last bit.
  [[nodiscard]] virtual std::vector<double> losses() const = 0;
  virtual void go_on_from_losses(const std::vector<double>& losses) = 0;
  [[nodiscard]] virtual Vec2 momentum() const = 0;
  struct Sums {
    double energy;
    Vec2 momentum;
  };
  /// Both.
  [[nodiscard]] virtual Sums sums() const { return {energy(), momentum()}; }
  /// Adds what the solver has counted: impacts, deepest overlap, seconds of the effects.
  virtual void count(Measurements& measurements) const = 0;
  /// Writes into the scene what it takes to go on bit for bit, but for balls and flights.
  virtual void save(Scene& scene) const = 0;
  /// Shows the balls from which a saved run goes on, and their flights where the method has any.
  virtual void visit_saved(const BallVisitor& visit) const { visit_state(visit); }
  virtual void visit_flights(const FlightVisitor& /*visit*/) const {}

  /// From now on every impact is noted, or none.  What is not asked for costs nothing.
  virtual void record_impacts(bool /*wanted*/) {}
  /// Adds the impacts noted since the last call, in any order; balls by their present numbers.  Of
  /// `event` it is only said which belong together: 0 for an impact by itself, else any number that
  /// the contacts of one joint impact share within a call.  `of_all`: those too that happened in a
  /// part of a step that is only shown, and that a later call would tell again.
  virtual void take_impacts(std::vector<Impact>& /*impacts*/, bool /*of_all*/) {}
  /// Adds the walls that this ball slides along now, which are noted only when it ends: for a ball
  /// that is removed, and at the end of a run.
  virtual void tell_slides(std::size_t /*ball*/, std::vector<Impact>& /*impacts*/) const {}
};

}  // namespace carom
