#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/command.hpp"
#include "carom/effects.hpp"
#include "carom/vector.hpp"

namespace carom {

/// The rectangle the balls live in.
///
/// Units: lengths of the scene.  The engine computes in the scene's own coordinates: with
/// `Origin::center` a mirror image is a change of sign and nothing is rounded.
struct Box {
  enum class Origin { corner, center };

  double width = 20;
  double height = 10;
  std::array<bool, 2> periodic{false, false};  ///< the x axis wraps, the y axis wraps
  Origin origin = Origin::corner;

  [[nodiscard]] Vec2 size() const { return {width, height}; }
  [[nodiscard]] Vec2 lower() const {
    return origin == Origin::corner ? Vec2{0, 0} : Vec2{-width / 2, -height / 2};
  }
  [[nodiscard]] Vec2 upper() const {
    return origin == Origin::corner ? Vec2{width, height} : Vec2{width / 2, height / 2};
  }
};

/// A recipe for many balls; drawn from the scene's seed alone, the same on every machine.
struct Fill {
  enum class Arrangement { random, square, hexagonal };

  std::size_t count = 0;
  double radius = 0.5;
  double mass = 1;
  double temperature = 0;  ///< k_B = 1: variance of each velocity component is temperature / mass
  Arrangement arrangement = Arrangement::random;
  std::optional<std::array<Vec2, 2>> region;  ///< lower and upper corner; the whole box if absent
  char glyph = 0;                             ///< of all its balls; 0: the painter's choice
};

enum class Method { overlap, event };

/// How the scene is computed.
struct SolverChoice {
  std::optional<Method> method;  ///< absent: `event` where it can take the scene, else `overlap`
  double step = 1.0 / 240;       ///< seconds
  int digits = 16;               ///< 16 (double), 34, 50 or 100; for `event`
};

/// A command and when it is due.
struct ScriptLine {
  double at = 0;  ///< seconds of the frame clock, which runs on while the simulation is paused
  Command command;
};

/// A ball's flight as method `event` holds it: where, when and how fast it left its last impact.
///
/// Units: decimal numbers as text, since they may have more digits than a double keeps.
struct SavedFlight {
  std::string start;  ///< ticks of the clock of the continuation, counted from its present epoch
  std::array<std::string, 2> position;
  std::array<std::string, 2> velocity;
  std::string spin;                 ///< empty where balls have none
  std::optional<std::size_t> left;  ///< the fixed ball at which it began
  unsigned support = 0;             ///< the axes along which something carries it: 1 for x, 2 for y
  double left_out = 0;  ///< energy that a flight of an elastic contact island is counted without
};

/// What method `event` has counted to find balls that are jammed.
struct SavedJam {
  std::string since;          ///< when the present span of time began: ticks, as of a flight
  std::uint64_t impacts = 0;  ///< in that span
  unsigned found = 0;         ///< how often the present jam has been found; 0: there is none
  unsigned found_before = 0;  ///< the same of the last one
  unsigned lasts = 1;         ///< for how many spans a jam lasts
  unsigned spans = 2;         ///< since one was found, or was over
};

/// Where a saved run stood; lets it go on bit for bit.
struct Continuation {
  double time = 0;      ///< simulated seconds
  double clock = 0;     ///< frame clock, seconds
  bool paused = false;  ///< the saved run stood still
  /// The frame clock and the simulated time when a pause last ended; simulated time is
  /// `time_origin` + (`clock` - `clock_origin`).  Absent: 0 where time and clock agree, else those.
  std::optional<double> clock_origin;
  std::optional<double> time_origin;
  double step_origin = 0;            ///< simulated time of step number 0 of the present step length
  std::uint64_t steps = 0;           ///< whole steps taken since `step_origin`
  std::optional<double> tick;        ///< of the clock of `event`, seconds: a power of two
  std::optional<SavedJam> jam;       ///< of method `event`, where elastic balls may touch for long
  bool rests = false;                ///< `event` looked for contacts that rest
  std::vector<SavedFlight> flights;  ///< of method `event`: of each ball, in order
};

/// Everything a run is determined by, as plain data.
///
/// Holds: nothing by itself; `read_scene` and `find_problems` tell a good scene from a bad one.
struct Scene {
  std::string name;
  std::string about;
  Box box;
  Effects effects;
  std::vector<Ball> balls;
  std::vector<Fill> fills;
  std::uint64_t seed = 0;
  SolverChoice solver;
  std::optional<std::size_t> workers;  ///< absent: the default of `worker_count`
  bool per_ball = false;               ///< one worker thread per ball; `workers` is then absent
  bool played = false;                 ///< in the terminal, which has its own default of workers
  double duration = 10;                ///< simulated seconds of a headless run
  double frame_rate = 30;              ///< frames per second of the frame clock
  std::vector<ScriptLine> script;      ///< in order of `at`
  std::optional<Continuation> continuation;
  std::string source;  ///< the file it was read from, for messages; no part of what is computed
};

/// The scene's balls, then those of its fills, in order.
/// Errors: SceneError where a fill does not find room.
std::vector<Ball> populate(const Scene& scene);

/// Whether its impacts lose energy along the normal, at the start or later by its script.
bool loses_energy(const Scene& scene);

/// The method a scene is computed with.
struct MethodChoice {
  Method method = Method::overlap;
  std::string why;        ///< as in "the scene names it"
  bool piles_up = false;  ///< by default event, but for so many balls that can pile up
};
MethodChoice choose_method(const Scene& scene);
/// Why overlap computes a scene that event could take: `check`, the summary of a run and the status
/// of `play` say it in these words.
inline constexpr const char* kPilesUp = "more than 300 balls can pile up";

/// Whether its method takes steps; else `solver.step` means nothing.
bool takes_steps(const Scene& scene);

/// What keeps a method from taking the scene, in words and with the remedy; empty: nothing does.
std::string obstacle(const Scene& scene, Method method);

/// The worker threads of a scene of `balls` balls, of which `moving` can move: as many as the scene
/// says.  By default, where it is played, one per ball that can move, up to 256, above that one per
/// core; elsewhere as many as make it fastest here.
std::size_t worker_count(const Scene& scene, std::size_t balls, std::size_t moving);
inline std::size_t worker_count(const Scene& scene, std::size_t balls) {
  return worker_count(scene, balls, balls);
}
/// How many of the balls can move.
std::size_t count_moving(const std::vector<Ball>& balls);

}  // namespace carom
