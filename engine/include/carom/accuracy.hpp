#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "carom/machine.hpp"
#include "carom/scene.hpp"

namespace carom {

/// Worker threads that a run is timed on.
struct AccuracyCrew {
  bool per_ball = false;
  std::size_t workers = 1;  ///< where not one per ball
};

struct AccuracyRow;

/// What chaos leaves to be known: averages, which every run can get right.
enum class Observable { Z, pressure, temperature, collision_rate, mean_free_path };

/// As scenes and options name it.
const char* observable_name(Observable observable);
inline constexpr std::array kObservables{Observable::Z, Observable::pressure,
                                         Observable::temperature, Observable::collision_rate,
                                         Observable::mean_free_path};

/// How far a study is.
struct AccuracyProgress {
  std::size_t run = 0;   ///< the run at hand, from 1; 0: the reference, or what follows the runs
  std::size_t runs = 0;  ///< of how many
  double left = 0;       ///< wall-clock seconds that are left, foreseen
  double part = 0;       ///< of the whole that is done, 0 to 1; never goes back
  std::string what;      ///< what is computed at the moment
};

/// What a study of accuracy is asked for.
struct AccuracyRequest {
  std::optional<double> time;    ///< simulated seconds; absent: the scene's duration
  std::optional<double> target;  ///< the error of position that is wanted
  /// The first computes every row, the others those of one run.  Empty: as the scene says, else one
  /// worker.
  std::vector<AccuracyCrew> crews;
  /// Starts of a scene that comes to rest, and of runs that are averaged, from its seed on.
  std::size_t seeds = 8;
  /// Averages to compare; none of a scene that comes to rest, where they tend to 0.
  std::vector<Observable> observables;
  double share = 2;  ///< time limit of one run, wall-clock seconds
  /// Called now and then, by the thread that asked for the study.
  std::function<void(const AccuracyProgress&)> progress;
  /// Called when a row is done; its horizon may still become sharper.
  std::function<void(const AccuracyRow&)> row_done;
  /// Asked often; once true, the study ends with the rows that are done.
  std::function<bool()> stopped;
};

/// A quantity over several starts.
struct MedianAndSpread {
  double median = 0;
  double spread = 0;  ///< the range of the middle half
};

/// A mean over several starts.
struct MeanAndError {
  double mean = 0;
  std::optional<double> standard_error;  ///< absent: there is one start
};

/// How a run from several starts came to rest.
struct AccuracyRest {
  /// Least |G f - w| / |w| over contact forces f within the friction cones, at the contacts closer
  /// than 1e-3 radii; w are the weights.
  MedianAndSpread equilibrium_residual;
  MedianAndSpread creep;           ///< farthest move of a ball in the last third of the time, radii
  MedianAndSpread kinetic_energy;  ///< at the end, of m g r summed over the balls that can move
  std::optional<MedianAndSpread> rest_time;  ///< seconds; absent: most starts never came to rest
  MedianAndSpread dissipation_error;         ///< the unexplained part of the energy book
  MedianAndSpread height;                    ///< of the centre of mass at the end, against gravity
};

/// One run of the scene, and how wrong it was.
struct AccuracyRow {
  Method method = Method::overlap;
  std::optional<double> step;  ///< seconds; absent: the run takes none
  int digits = 16;
  std::size_t workers = 1;
  bool per_ball = false;
  std::string failure;  ///< why there are no numbers; empty: there are

  double seconds = 0;  ///< wall clock, the median of the repeats
  double fastest = 0;  ///< their spread: the ends, and those of the middle half
  double slowest = 0;
  std::array<double, 2> quartiles{0, 0};
  /// CPU time of all threads, the median of the repeats.  Less than `seconds`: other programs had
  /// the processor.
  double cpu_seconds = 0;
  std::size_t repeats = 0;
  /// Largest distance of a ball from where it should be at the end; absent where the reference does
  /// not reach so far.
  std::optional<double> position_error;
  /// What nothing accounts for at the end: Measurements::relative_energy_error.
  std::optional<double> energy_error;
  double max_overlap = 0;       ///< deepest penetration seen / smaller radius of the two
  std::uint64_t ball_ball = 0;  ///< impacts
  std::uint64_t ball_wall = 0;
  /// Simulated seconds until a ball is first seen farther than 1 % of the smallest radius from
  /// where it should be; absent: not within the time.
  std::optional<double> horizon;
  double horizon_resolution = 0;  ///< it was not so this long before
  /// Where the scene comes to rest; the errors and the horizon are then absent, and the other
  /// figures are medians over the starts.
  std::optional<AccuracyRest> rest;
  /// As the study's `observables`, over its starts; empty: none were asked for, or the runs would
  /// take too long.
  std::vector<std::optional<MeanAndError>> averages;
};

/// The run that the others are held against.
struct AccuracyReference {
  /// There is none: the scene comes to rest, and its ends are held against static equilibrium.
  bool equilibrium = false;
  /// There is none, and this is why: only averages are compared.  Empty: there is one.
  std::string absent;
  Method method = Method::event;
  int digits = 0;
  std::optional<double> step;          ///< seconds; absent: it takes none
  int checked_digits = 0;              ///< of the run that it was compared with, ...
  std::optional<double> checked_step;  ///< ... its step, ...
  double difference = 0;  ///< ... and the largest distance of a ball between the two at any time
  double seconds = 0;     ///< wall clock of both
  /// Where the two part by more than 1 % of the smallest radius: what comes after is unknown to
  /// all.  Absent: they do not.
  std::optional<double> holds_until;
  std::uint64_t ball_ball = 0;  ///< impacts until then, or the end
  std::uint64_t ball_wall = 0;
};

/// What accuracy costs in one scene.
struct AccuracyStudy {
  std::string scene;
  double time = 0;  ///< simulated seconds
  std::size_t balls = 0;
  double smallest_radius = 0;  ///< 0: there is no ball
  std::uint64_t seed = 0;
  std::size_t starts = 1;  ///< from this seed on
  bool drawn = false;      ///< the scene has fills: each seed is another start
  Machine machine;
  AccuracyReference reference;
  std::vector<AccuracyRow> rows;
  std::vector<Observable> observables;
  /// As the observables: the means of the reference, which is method event from the same starts.
  std::vector<std::optional<MeanAndError>> averages;
  int average_digits = 16;  ///< of the reference that is averaged: 34 where there is time for it
  /// Why the sequence of steps ends where it does; empty: at its shortest step.
  std::string sequence_end;
  std::size_t runs = 0;  ///< that were planned, without those that the time limit left out
  bool stopped = false;  ///< ended early, as asked
  std::optional<double> target;
  std::optional<std::size_t> recommended;  ///< the cheapest row that meets the target

  /// No run is known to be right until the end, so that errors at the end say nothing and the
  /// predictability horizon is the answer.
  [[nodiscard]] bool judged_by_horizon() const;
  /// How long a row is right, seconds: its horizon, or at least as long as the reference is.
  [[nodiscard]] double right_until(const AccuracyRow& row) const;
  /// What a row is judged by where it should come to rest: the larger of residual and overlap.
  [[nodiscard]] static double rest_error(const AccuracyRow& row);
  /// CPU time of all rows over their wall-clock time where other programs had more than a tenth of
  /// it; absent: the machine was quiet.
  [[nodiscard]] std::optional<double> processor_share() const;
  /// A row's price.
  [[nodiscard]] double seconds_per_simulated_second(const AccuracyRow& row) const;
};

/// Whether losses under gravity bring the balls to rest, so that the end is an equilibrium and
/// there is no exact trajectory to compare with.
bool comes_to_rest(const Scene& scene);

/// There is nothing to hold the runs against; `what()` says why and what would help, in one line.
class NoReference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs the scene in every way that can take it and holds each against the truth.
///
/// The script is obeyed, at the simulated times its lines fall on; its changes of the step are not,
/// since each run keeps its own.
/// Errors: SceneError for a scene that cannot be run at all; NoReference; a run that fails is a row
/// that says so.
AccuracyStudy study_accuracy(const Scene& scene, const AccuracyRequest& request);

/// The cheapest row whose error of position, or where the scene comes to rest, whose residual and
/// overlap, are at most `target`; of rows whose times cannot be told
/// apart, the one with the fewest digits.
std::optional<std::size_t> cheapest_within(const AccuracyStudy& study, double target);

/// The Pareto front: the rows than which no other is both cheaper and nearer to the reference, or,
/// where that is what they are judged by, right for longer.  Ties go to fewer digits.
std::vector<bool> best_choices(const AccuracyStudy& study);

/// The study as a JSON object.
std::string to_json(const AccuracyStudy& study);

}  // namespace carom
