#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "carom/command.hpp"
#include "carom/exact_position.hpp"
#include "carom/frame.hpp"
#include "carom/impact.hpp"
#include "carom/measurements.hpp"
#include "carom/scene.hpp"
#include "carom/scene_stream.hpp"
#include "carom/timeline.hpp"

namespace carom {

/// A command that cannot be obeyed; nothing has changed.  `what()` says why, in one line.
class CommandError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a run that goes on needs beside its scene to write the same: what balls and events are
/// called from here on, and from what its energies add up.
struct Bookkeeping {
  std::vector<std::size_t> ids;  ///< of the balls, in their order
  std::size_t next_id = 0;
  std::uint64_t next_event = 0;
  double energy_input = 0;     ///< by commands
  std::vector<double> losses;  ///< as the solver sums them up
};

/// The state of a scene, one solver, only the effects asked for, and the crew of workers.
///
/// Threads: made, used and destroyed by one thread, the control thread.
/// Errors: the constructor throws SceneError for a scene that cannot be run and CrewError where the
/// system refuses the threads; `advance_to` rethrows what a worker threw, after which the
/// simulation can only be destroyed.
class Simulation {
 public:
  explicit Simulation(const Scene& scene);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Moves on to the state at `time` (simulated seconds, not before the present time).
  void advance_to(double time);

  /// Adds or removes a ball, changes effects or the step; the commands of the frame clock (pause,
  /// resume, quit) are not for the simulation and are refused with std::logic_error.
  /// Errors: CommandError where there is no room or no such ball or effect.
  void apply(const Command& command);

  [[nodiscard]] double time() const;  ///< simulated seconds: the last `advance_to`
  [[nodiscard]] std::size_t balls() const;
  [[nodiscard]] std::size_t workers() const;
  [[nodiscard]] Method method() const;
  [[nodiscard]] double step() const;
  [[nodiscard]] const Effects& effects() const;  ///< as they are now

  [[nodiscard]] Frame frame() const;
  [[nodiscard]] Measurements measure() const;
  /// The balls as they are now, in the order of the scene's balls, its fills, and later additions.
  [[nodiscard]] std::vector<Ball> state() const;
  /// The same balls one by one, without a copy of all.
  void visit_state(const std::function<void(const Ball&)>& visit) const;
  /// Where they are to the last digit that is computed: `state` rounds to double.
  [[nodiscard]] std::vector<ExactPosition> exact_positions() const;
  /// Hexadecimal digest of the exact bits of the state.
  [[nodiscard]] std::string state_hash() const;
  /// The present state as a scene that goes on bit for bit; without script and frame clock.
  [[nodiscard]] Scene save() const;
  /// The same for `write_scene`, without a copy of the balls.
  [[nodiscard]] SceneStream save_stream() const;

  /// The number that each ball of `state` keeps for good: its place among the scene's balls, its
  /// fills and later additions, whatever has been removed.
  [[nodiscard]] const std::vector<std::size_t>& ids() const;
  /// REQUIRES: the impacts that were noted have been taken.
  [[nodiscard]] Bookkeeping bookkeeping() const;
  /// REQUIRES: a number for each ball.
  void go_on_from(const Bookkeeping& bookkeeping);

  /// Notes every impact and command from now on, or none any more.  Nothing else changes.
  void record_impacts(bool wanted);
  /// Those noted since the last call, in the order of is_before, numbered from 0 on through all
  /// calls.  The same for any number of workers.  With attraction, what has happened since the last
  /// whole step is told only at the end of the run: until then it is done again.
  [[nodiscard]] std::vector<Impact> take_impacts(bool at_the_end = false);

  /// Records from now on what the control thread and the workers do between the barriers, and keeps
  /// the last `frames` calls of `advance_to`; 0: no longer, and forgets them.
  void record_timeline(std::size_t frames);
  /// The last `frames` of them, or all that are kept.
  [[nodiscard]] Timeline timeline(std::size_t frames = static_cast<std::size_t>(-1)) const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom
