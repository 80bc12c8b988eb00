#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "carom/report.hpp"
#include "carom/scene_file.hpp"
#include "carom/session.hpp"
#include "commands.hpp"
#include "export/output_file.hpp"
#include "export/unfinished_files.hpp"
#include "load_scene.hpp"
#include "one_file.hpp"
#include "progress.hpp"
#include "run_outputs.hpp"
#include "schedule.hpp"
#include "standard_streams.hpp"
#include "stretch.hpp"
#include "summary.hpp"
#include "warnings.hpp"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

/// Every file that a run writes, with its option.
std::vector<std::pair<const char*, const std::string&>> files_of(const Options& options) {
  return {{"--dump", options.dump},     {"--trajectory", options.trajectory},
          {"--events", options.events}, {"--series", options.series},
          {"--trace", options.trace},   {"--cast", options.cast},
          {"--report", options.report}, {"--save", options.save}};
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

}  // namespace

int run(const Options& options) {
  refuse_one_file_for_two(files_of(options));
  const Scene scene = load_scene(options.scenes.front(), options);

  print_warnings(scene, seconds_of(scene, options));

  // Opened before anything runs: what cannot be written is found now.
  unfinished_files::remove_on_signals();
  RunOutputs outputs(options);
  OutputFile report_file("--report", options.report);
  OutputFile save("--save", options.save);

  const auto started = Clock::now();
  Session session(scene);
  Schedule schedule(session, options);
  Progress progress(!options.quiet);
  outputs.begin(session);
  outputs.frame(schedule.frame());
  const bool watched = outputs.look_at_frames();
  Stretch stretch(!watched && progress.shown());
  while (watched ? schedule.next_frame() : schedule.next_frames(stretch.frames())) {
    outputs.frame(schedule.frame());
    progress.show(schedule.part_done(), session.simulation().time());
    stretch.adapt();
  }
  outputs.end(schedule.frame());
  progress.erase();

  Report report = make_report(session);
  report.frames = schedule.frames();
  report.ended = end_name(schedule.end());
  report.wall_seconds = std::chrono::duration<double>(Clock::now() - started).count();
  report_file.write(to_json(report, !options.no_state));
  save.write(write_scene(session.save()));

  outputs.commit();
  report_file.commit();
  save.commit();
  if (options.quiet) return 0;
  if (takes_standard_output(options)) {
    print_error(to_summary(report));
  } else {
    print(to_summary(report));
  }
  return 0;
}

}  // namespace carom
