#include <fmt/format.h>

#include <array>
#include <chrono>
#include <string>
#include <utility>

#include "carom/report.hpp"
#include "carom/scene_file.hpp"
#include "carom/session.hpp"
#include "commands.hpp"
#include "export/output_file.hpp"
#include "export/unfinished_files.hpp"
#include "load_scene.hpp"
#include "one_file.hpp"
#include "progress.hpp"
#include "schedule.hpp"
#include "standard_streams.hpp"
#include "stretch.hpp"
#include "summary.hpp"
#include "view/paint.hpp"
#include "view/text_screen.hpp"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

bool takes_standard_output(const Options& options) {
  return is_standard_output(options.dump) || is_standard_output(options.report) ||
         is_standard_output(options.save);
}

/// Whether frames are looked at: what is written once a frame.
bool looks_at_frames(const Options& options) {
  return !options.dump.empty();
}

void dump_frame(const Session& session, std::uint64_t number, const Options& options,
                OutputFile& file) {
  if (!file || number % options.every != 0) return;
  Canvas canvas(options.columns, options.rows);
  paint(session.simulation().frame(), canvas);
  file.write(to_text(canvas, number, session.simulation().time()));
}

}  // namespace

int run(const Options& options) {
  refuse_one_file_for_two(
      {{"--dump", options.dump}, {"--report", options.report}, {"--save", options.save}});
  const Scene scene = load_scene(options.scenes.front(), options);

  // Opened before anything runs: what cannot be written is found now.
  unfinished_files::remove_on_signals();
  OutputFile dump("--dump", options.dump);
  OutputFile report_file("--report", options.report);
  OutputFile save("--save", options.save);

  const auto started = Clock::now();
  Session session(scene);
  Schedule schedule(session, options);
  Progress progress(!options.quiet);
  dump_frame(session, schedule.frame(), options, dump);
  const bool watched = looks_at_frames(options);
  Stretch stretch(!watched && progress.shown());
  while (watched ? schedule.next_frame() : schedule.next_frames(stretch.frames())) {
    dump_frame(session, schedule.frame(), options, dump);
    progress.show(schedule.part_done(), session.simulation().time());
    stretch.adapt();
  }
  progress.erase();

  Report report = make_report(session);
  report.frames = schedule.frames();
  report.ended = end_name(schedule.end());
  report.wall_seconds = std::chrono::duration<double>(Clock::now() - started).count();
  report_file.write(to_json(report));
  save.write(write_scene(session.save()));

  dump.commit();
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
