#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "carom/crew.hpp"
#include "carom/exact_position.hpp"
#include "carom/impact.hpp"
#include "carom/scene.hpp"
#include "state/domain.hpp"
#include "state/totals.hpp"

namespace carom::event {

/// By which way several balls are solved; no result depends on it.
struct Sharing {
  // In domains of the plane:
  std::size_t least_balls = 200;      ///< with fewer balls they are not,
  std::size_t balls_of_worker = 250;  ///< nor with fewer for each of several workers.
  /// So many balls of which some may come to rest in heaps are solved by one event loop, whose
  /// islands several workers share.
  std::size_t balls_of_one_loop = 1500;
};

/// What a core starts from.
struct CoreStart {
  Domain domain;
  Effects effects;
  std::vector<Ball> balls;  ///< in the order of the scene; a fixed one has velocity 0
  Continuation from;        ///< time 0 and no flights for a fresh start
  bool rests = false;       ///< contacts can come to rest
  std::size_t workers = 1;
  Sharing sharing;
  std::string source;  ///< the scene's file, for messages
};

/// What has happened since the start.
struct Tally {
  std::uint64_t ball_ball = 0;
  std::uint64_t ball_wall = 0;
  std::uint64_t joint_impacts = 0;
  std::uint64_t jammed = 0;
  std::uint64_t resting_contacts = 0;
  std::uint64_t islands_again = 0;  ///< domains
  double max_overlap = 0;
  // wall-clock seconds
  double collisions = 0;
  double walls = 0;
  double friction = 0;
  double bending = 0;  ///< of flights, by gravity and drag
};

/// The flights of all balls and the order of their impacts: what EventSolver drives.
///
/// A core knows flights and impacts only; scenes, effects' names, hashes and energy are the
/// façade's.  Balls have the numbers of the scene here, whatever their order inside.
///
/// Holds: the state at a time does not depend on when it was looked at, the workers or the sharing.
/// Threads: the control thread calls everything, while no phase runs; the phases run on the crew.
/// Errors: the constructor throws SceneError where saved flights cannot be; a phase throws
/// std::runtime_error where impacts have no end.
class Core {
 public:
  Core() = default;
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;
  virtual ~Core() = default;

  // Moving on, as in Solver.
  [[nodiscard]] virtual std::vector<Phase> phases() = 0;
  [[nodiscard]] virtual std::size_t aim(double time) = 0;
  virtual void set_workers(std::size_t workers) = 0;

  // Changes at the present time.
  virtual void add(const Ball& ball) = 0;
  virtual void remove(std::size_t ball) = 0;
  /// `bends`: gravity or drag has changed, so that all flights start again where they are.
  virtual void set(const Domain& domain, const Effects& effects, bool bends) = 0;

  // The present state.
  /// The balls with what does not change of them while they fly; a fixed one is where it is.
  [[nodiscard]] virtual const std::vector<Ball>& balls() const = 0;
  /// Sets position, velocity and spin of those that move of the balls from number `first` on.
  virtual void read_balls(std::size_t first, std::span<Ball> balls) const = 0;
  /// Of all balls.
  /// REQUIRES: one for each.
  void read_balls(std::vector<Ball>& balls) const { read_balls(0, balls); }
  [[nodiscard]] virtual std::vector<ExactPosition> exact_positions() const = 0;
  /// How often each ball has gone round the periodic axes that gravity pulls along.
  [[nodiscard]] virtual Turns turns() const = 0;
  /// The energy that gravity has given to stepped contacts ahead of the fall of their next step.
  [[nodiscard]] virtual double energy_ahead() const = 0;
  /// The energy that impacts and drag have taken since the start.
  [[nodiscard]] virtual double dissipated() const = 0;
  /// As in Solver: terms whose exact sum it is, but for the drag of present flights.
  [[nodiscard]] virtual std::vector<double> losses() const = 0;
  virtual void go_on_from_losses(const std::vector<double>& losses) = 0;
  [[nodiscard]] virtual Tally tally() const = 0;
  /// As in Solver: notes impacts, and gives those noted since the last call.
  virtual void record_impacts(bool /*wanted*/) {}
  virtual void take_impacts(std::vector<Impact>& /*impacts*/) {}
  virtual void tell_slides(std::size_t /*ball*/, std::vector<Impact>& /*impacts*/) const {}
  /// Writes the tick of the clock and whether contacts can rest.
  virtual void save(Continuation& continuation) const = 0;
  /// Shows the flights in the order of the balls.
  virtual void visit_flights(const std::function<void(const SavedFlight&)>& visit) const = 0;
};

}  // namespace carom::event
