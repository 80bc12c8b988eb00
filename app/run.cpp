#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "carom/report.hpp"
#include "carom/scene_file.hpp"
#include "carom/session.hpp"
#include "checkpoint.hpp"
#include "commands.hpp"
#include "export/output_file.hpp"
#include "export/unfinished_files.hpp"
#include "frames_at_once.hpp"
#include "load_scene.hpp"
#include "one_file.hpp"
#include "progress.hpp"
#include "run_outputs.hpp"
#include "schedule.hpp"
#include "standard_streams.hpp"
#include "summary.hpp"
#include "warnings.hpp"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

/// Every file that a run writes, with its option.
std::vector<std::pair<const char*, const std::string&>> files_of(const Options& options) {
  return {{"--dump", options.dump},
          {"--trajectory", options.trajectory},
          {"--events", options.events},
          {"--series", options.series},
          {"--trace", options.trace},
          {"--cast", options.cast},
          {"--report", options.report},
          {"--save", options.save},
          {"--checkpoint", options.checkpoint}};
}

bool takes_standard_output(const Options& options) {
  const auto files = files_of(options);
  return std::any_of(files.begin(), files.end(),
                     [](const auto& file) { return is_standard_output(file.second); });
}

double seconds_of(const Scene& scene, const Options& options) {
  if (options.frames) return static_cast<double>(*options.frames) / scene.frame_rate;
  return options.time.value_or(scene.duration);
}

/// What cannot be written before the run is wrong usage.
template <class Open>
void refuse_unwritable(const Open& open) {
  try {
    open();
  } catch (const std::system_error& error) {
    throw UsageError(error.what());
  }
}

/// What went to standard output is gone when the run goes on.
void refuse_what_cannot_go_on(const Options& options) {
  if (options.checkpoint.empty()) return;
  for (const auto& [option, file] : files_of(options)) {
    const std::string name = option;
    if (name == "--report" || name == "--save" || !is_standard_output(file)) continue;
    throw UsageError(fmt::format(
        "{}: with --checkpoint it must be a file: standard output cannot be taken back", name));
  }
}

/// What identifies a run, in one line.
std::string identity(const Scene& scene, const Options& options) {
  std::string text = fmt::format("carom {} time {} frames {} every {} size {}x{}", version(),
                                 options.time.value_or(-1),
                                 options.frames ? fmt::format("{}", *options.frames) : "-",
                                 options.every, options.columns, options.rows);
  for (const auto& [option, file] : files_of(options)) {
    if (!file.empty()) text += fmt::format(" {} {}", option, file);
  }
  text += ' ' + write_scene(scene);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

Checkpoint checkpoint_of(const Session& session, const Schedule& schedule, RunOutputs& outputs,
                         const std::optional<Checkpoint>& earlier) {
  Checkpoint checkpoint;
  checkpoint.frame = schedule.frame();
  checkpoint.first_frame = schedule.beginning().frame;
  checkpoint.start_time = schedule.beginning().time;
  checkpoint.measured = session.simulation().measure();
  if (earlier) checkpoint.measured = together(earlier->measured, checkpoint.measured);
  checkpoint.bookkeeping = session.simulation().bookkeeping();
  checkpoint.scene = session.save();
  outputs.keep(checkpoint);
  return checkpoint;
}

}  // namespace

int run(const Options& options) {
  refuse_one_file_for_two(files_of(options));
  refuse_what_cannot_go_on(options);
  const Scene scene = load_scene(options.scenes.front(), options);

  print_warnings(scene, seconds_of(scene, options));

  // Opened before anything runs: what cannot be written is found now.
  unfinished_files::remove_on_signals();
  std::optional<RunOutputs> outputs;
  std::optional<OutputFile> report_file;
  std::optional<OutputFile> save;
  refuse_unwritable([&] {
    outputs.emplace(options);
    report_file.emplace("--report", options.report);
    save.emplace("--save", options.save);
  });

  const auto started = Clock::now();
  CheckpointFile checkpoints(options.checkpoint, options.checkpoint_every,
                             options.checkpoint.empty() ? "" : identity(scene, options));
  std::optional<Checkpoint> earlier = checkpoints.read();
  auto holder = std::make_unique<Session>(earlier ? earlier->scene : scene);
  if (earlier) holder->simulation().go_on_from(earlier->bookkeeping);
  if (earlier && !outputs->go_on(*holder, *earlier)) {
    print_error("carom: --checkpoint: its unfinished files are gone: the run begins again\n");
    earlier.reset();
    holder.reset();  // its threads end before those of the next begin
    holder = std::make_unique<Session>(scene);
  }
  Session& session = *holder;
  std::optional<Schedule::Beginning> beginning;
  if (earlier) beginning = {earlier->first_frame, earlier->start_time};
  Schedule schedule(session, options, beginning);
  Progress progress(!options.quiet);
  if (!earlier) refuse_unwritable([&] { outputs->begin(session, schedule.frame()); });
  const bool watched = outputs->look_at_frames();
  FramesAtOnce at_once(!watched && (progress.shown() || checkpoints));
  while (watched ? schedule.next_frame() : schedule.next_frames(at_once.frames())) {
    outputs->frame(schedule.frame());
    progress.show(schedule.part_done(), session.simulation().time());
    at_once.adapt();
    if (checkpoints.due() && outputs->leaves(schedule.frame())) {
      checkpoints.write(checkpoint_of(session, schedule, *outputs, earlier));
    }
  }
  outputs->end(schedule.frame());
  progress.erase();

  const Measurements since = session.simulation().measure();
  Report report = make_report(session, earlier ? together(earlier->measured, since) : since);
  report.frames = schedule.frames();
  report.ended = end_name(schedule.end());
  report.wall_seconds = std::chrono::duration<double>(Clock::now() - started).count();
  if (*report_file) {
    write_report(report, options.no_state ? nullptr : &session.simulation(),
                 [&](std::string_view text) { report_file->write(text); });
  }
  if (*save) {
    write_scene(session.save_stream(), [&](std::string_view text) { save->write(text); });
  }

  outputs->commit();
  report_file->commit();
  save->commit();
  checkpoints.remove();
  if (options.quiet) return 0;
  if (takes_standard_output(options)) {
    print_error(to_summary(report));
  } else {
    print(to_summary(report));
  }
  return 0;
}

}  // namespace carom
