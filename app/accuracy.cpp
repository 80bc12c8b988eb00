#include "carom/accuracy.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

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
  for (const std::string& crew : options.crews) {
    const bool per_ball = crew == "per-ball";
    request.crews.push_back({per_ball, per_ball ? 1 : std::stoull(crew)});
  }
  return request;
}

std::string in_words(const AccuracyStudy& study) {
  return to_table(study) + '\n' + to_plot(study) + '\n' + to_sentences(study);
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
  // Opened before anything runs: what cannot be written is found now.
  unfinished_files::remove_on_signals();
  OutputFile json("--json", options.json);
  OutputFile csv("--csv", options.csv);
  Gnuplot plot("--plot", options.plot);

  AccuracyRequest request = request_of(options);
  Progress progress(!options.quiet);
  request.progress = [&](double part, double left, const std::string& what) {
    progress.show_left(part, left, what);
  };
  const AccuracyStudy study = study_accuracy(scene, request);
  progress.erase();

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
