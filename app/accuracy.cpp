#include "carom/accuracy.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <string>
#include <utility>

#include "accuracy_averages.hpp"
#include "accuracy_plot.hpp"
#include "accuracy_table.hpp"
#include "accuracy_words.hpp"
#include "commands.hpp"
#include "export/accuracy_csv.hpp"
#include "export/accuracy_gnuplot.hpp"
#include "export/output_file.hpp"
#include "export/unfinished_files.hpp"
#include "load_scene.hpp"
#include "one_file.hpp"
#include "progress.hpp"
#include "standard_streams.hpp"

namespace carom {
namespace {

constexpr double kMostSeconds = 0x1p53 / 30720;  // whose steps are all counted

AccuracyRequest request_of(const Options& options) {
  AccuracyRequest request;
  request.time = options.time;
  request.target = options.target;
  request.share = options.share;
  request.seeds = options.seeds;
  for (const Observable each : kObservables) {
    const auto& names = options.observables;
    if (std::find(names.begin(), names.end(), observable_name(each)) != names.end()) {
      request.observables.push_back(each);
    }
  }
  for (const std::string& crew : options.crews) {
    const bool per_ball = crew == "per-ball";
    request.crews.push_back({per_ball, per_ball ? 1 : std::stoull(crew)});
  }
  return request;
}

std::string in_words(const AccuracyStudy& study) {
  return to_table(study) + to_average_table(study) + '\n' + to_plot(study) + '\n' +
         to_sentences(study) + to_average_sentences(study);
}

constexpr int kStopped = 128 + SIGINT;  // exit status, as shells have it

volatile std::sig_atomic_t interrupts = 0;
struct sigaction before_interrupt;  // what an interrupt did before

/// The first interrupt ends the study, the second the program.
void take_interrupt(int) {
  interrupts = 1;
  (void)sigaction(SIGINT, &before_interrupt, nullptr);
}

/// From here to the end of its life an interrupt is noted.
class Interrupt {
 public:
  Interrupt() {
    struct sigaction action {};
    action.sa_handler = take_interrupt;
    (void)sigaction(SIGINT, nullptr, &before_interrupt);
    if (before_interrupt.sa_handler != SIG_IGN) (void)sigaction(SIGINT, &action, nullptr);
  }
  ~Interrupt() { (void)sigaction(SIGINT, &before_interrupt, nullptr); }
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] static bool seen() { return interrupts != 0; }
};

std::string said(const AccuracyProgress& progress) {
  if (progress.run == 0) return progress.what;
  return fmt::format("run {} of {}: {}", progress.run, progress.runs, progress.what);
}

/// A row while the study goes on: what it is and its figures so far.
std::string live_line(const AccuracyRow& row, double time) {
  if (!row.failure.empty()) return fmt::format("  {:<20}  {}", run_name(row), row.failure);
  if (row.rest) {
    return fmt::format(
        "  {:<20}  {:>8} per s  residual {:>8}  overlap {:>8}  {}", run_name(row),
        duration_text(time > 0 ? row.seconds / time : 0),
        error_text(row.rest->equilibrium_residual.median), error_text(row.max_overlap),
        row.rest->rest_time ? fmt::format("at rest at {:.3g} s", row.rest->rest_time->median)
                            : "never at rest");
  }
  return fmt::format("  {:<20}  {:>8} per s  position {:>8}  energy {:>8}  {}", run_name(row),
                     duration_text(time > 0 ? row.seconds / time : 0),
                     row.position_error ? error_text(*row.position_error) : "lost",
                     row.energy_error ? error_text(*row.energy_error) : "unknown",
                     row.horizon ? fmt::format("right for {:.4g} s", *row.horizon) : "");
}

}  // namespace

int accuracy(const Options& options) {
  refuse_one_file_for_two(
      {{"--json", options.json}, {"--csv", options.csv}, {"--plot", options.plot}});
  const Scene scene = load_scene(options.scenes.front(), options);
  if (options.time.value_or(scene.duration) > kMostSeconds) {
    throw UsageError(fmt::format("--time: must be at most {:.3g}, got {:.3g}", kMostSeconds,
                                 options.time.value_or(scene.duration)));
  }
  if (!options.observables.empty() && comes_to_rest(scene)) {
    throw UsageError(
        "--observable: losses under gravity bring the scene to rest, and its averages end with it; "
        "without --observable its rest is judged");
  }
  for (const std::string& name : options.observables) {
    if ((name == "collision_rate" || name == "mean_free_path") && !scene.effects.collisions) {
      throw UsageError(fmt::format(
          "--observable {}: the scene has no collisions; add them to its effects", name));
    }
  }
  // Opened before anything runs: what cannot be written is found now.
  unfinished_files::remove_on_signals();
  OutputFile json("--json", options.json);
  OutputFile csv("--csv", options.csv);
  Gnuplot plot("--plot", options.plot);

  AccuracyRequest request = request_of(options);
  Progress progress(!options.quiet);
  request.progress = [&](const AccuracyProgress& at) {
    progress.show_left(at.part, at.left, said(at));
  };
  const double time = options.time.value_or(scene.duration);
  request.row_done = [&](const AccuracyRow& row) { progress.print_above(live_line(row, time)); };
  const Interrupt interrupt;
  request.stopped = [&] { return interrupt.seen(); };
  const AccuracyStudy study = study_accuracy(scene, request);
  progress.erase();
  if (study.stopped) {
    if (!options.quiet && !study.rows.empty()) print(in_words(study));
    print_error(fmt::format("carom: stopped with {} of {} runs done{}\n", study.rows.size(),
                            study.runs,
                            options.json.empty() && options.csv.empty() && options.plot.empty()
                                ? ""
                                : "; no file is written"));
    return kStopped;
  }

  json.write(to_json(study));
  csv.write(to_csv(study));
  plot.draw(study);
  json.commit();
  csv.commit();
  plot.commit();
  if (options.quiet) return 0;
  const bool taken = is_standard_output(options.json) || is_standard_output(options.csv);
  if (taken) {
    print_error(in_words(study));
  } else {
    print(in_words(study));
  }
  return 0;
}

}  // namespace carom
