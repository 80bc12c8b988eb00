#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "carom/frame_clock.hpp"
#include "carom/simulation.hpp"

namespace carom {

/// A simulation on its frame clock: script, pause and quit.  `play` and `run` both drive this.
///
/// The frame clock counts frames / frame_rate.  Script lines take effect exactly at their time,
/// between frames, so that the trajectory depends on no frame rate.
///
/// Threads: the control thread only.
class Session {
 public:
  explicit Session(Scene scene);

  /// Moves the frame clock on to `clock` seconds, obeying the script on its way.
  void advance_clock_to(double clock);
  /// Moves simulated time on by `seconds` without the frame clock: one frame while paused.
  void nudge(double seconds);
  /// The same, on to a simulated time.
  void nudge_to(double time);
  /// Obeys a command now.
  void apply(const Command& command);

  [[nodiscard]] bool paused() const { return clock_.paused(); }
  [[nodiscard]] bool quit() const { return quit_; }
  /// When the next line of the script is due, on the frame clock; none is left: none.
  [[nodiscard]] std::optional<double> next_line() const;
  /// Paused, and no line of the script is left that could change it.
  [[nodiscard]] bool stuck() const;
  [[nodiscard]] double clock() const { return clock_.now(); }
  /// The frame clock at a simulated time, if no pause comes before.
  [[nodiscard]] double clock_at(double time) const { return clock_.at(time); }

  /// The effects with the values they last had while they were on; initially those of the scene.
  [[nodiscard]] const Effects& effects_when_on() const { return when_on_; }
  /// Of a session that goes on as another one.
  void set_effects_when_on(const Effects& effects) { when_on_ = effects; }
  /// What switches an effect of the scene off, or on with the values it last had; nothing where the
  /// scene does not name it.
  struct Switch {
    command::SetEffects change;
    bool on = false;  ///< afterwards
  };
  [[nodiscard]] std::optional<Switch> switch_of(std::string_view effect) const;

  [[nodiscard]] Simulation& simulation() { return simulation_; }
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }

  /// The present state, rest of the script and frame clock as a scene that goes on bit for bit.
  [[nodiscard]] Scene save() const;
  /// The same for `write_scene`, without a copy of the balls.
  [[nodiscard]] SceneStream save_stream() const;

  /// What was done so far as a scene: the same start, a script of the commands that were obeyed, by
  /// simulated time, and the time that has passed as its duration.  A run of it ends in the same
  /// bits; pauses, which change nothing, are left out.
  [[nodiscard]] Scene log() const;
  /// Of a session that goes on where another one stood: its log goes on from the log of that one.
  void go_on_from(const Scene& log);
  /// How many commands were obeyed that the log has.
  [[nodiscard]] std::size_t commands() const { return obeyed_.size(); }

 private:
  void move_clock_to(double clock);

  Scene scene_;
  Simulation simulation_;
  FrameClock clock_;
  bool quit_ = false;
  Effects when_on_;
  std::size_t next_line_ = 0;
  std::optional<Scene> log_start_;  // absent: the scene
  std::vector<ScriptLine> obeyed_;  // commands for the simulation, by simulated time
};

}  // namespace carom
