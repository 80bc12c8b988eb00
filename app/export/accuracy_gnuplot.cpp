#include "export/accuracy_gnuplot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "carom/report.hpp"

namespace carom {
namespace {

constexpr int kDouble = 16;  // digits

/// Whether a folder of PATH has it.
bool is_installed(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

struct Pipe {
  std::array<int, 2> ends{-1, -1};

  Pipe() {
    // A pair of sockets: unlike a pipe, it can be written without a signal when the reader is gone.
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) fail("gnuplot");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void close_end(std::size_t end) {
    if (ends[end] >= 0) (void)close(ends[end]);
    ends[end] = -1;
  }
};

/// Runs gnuplot on a script, which is short enough for a pipe to hold; gives what it writes.
std::string drawn(const std::string& script) {
  Pipe in;
  Pipe out;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.ends[1], STDOUT_FILENO);
  for (const Pipe* const pipe : {&in, &out}) {
    for (const int end : pipe->ends) posix_spawn_file_actions_addclose(&actions, end);
  }
  std::array<std::string, 2> words{"gnuplot", "-"};
  std::array<char*, 3> arguments{words[0].data(), words[1].data(), nullptr};
  pid_t child = -1;
  errno = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (errno != 0) fail("gnuplot");
  in.close_end(0);
  out.close_end(1);
  const bool told = send(in.ends[1], script.data(), script.size(), MSG_NOSIGNAL) ==
                    static_cast<ssize_t>(script.size());
  in.close_end(1);
  std::string picture;
  std::array<char, 4096> buffer{};
  for (ssize_t got = 0; (got = read(out.ends[0], buffer.data(), buffer.size())) != 0;) {
    if (got > 0) picture.append(buffer.data(), static_cast<std::size_t>(got));
    if (got < 0 && errno != EINTR) break;
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!told || !WIFEXITED(status) || WEXITSTATUS(status) != 0 || picture.empty()) {
    throw std::runtime_error("--plot: gnuplot failed; the file is as it was");
  }
  return picture;
}

/// The scene's name, without what gnuplot reads as more than text.
std::string title_of(const AccuracyStudy& study) {
  std::string title;
  for (const char c : study.scene) {
    if (c != '"' && c != '\\' && c != '\n' && c != '`') title += c;
  }
  return title;
}

/// A run's height: its error, or how long it is right, or where it should come to rest its residual
/// or its overlap; absent where the reference does not tell.
std::optional<double> height_of(const AccuracyStudy& study, const AccuracyRow& row, bool residual) {
  if (!row.failure.empty()) return std::nullopt;
  if (row.rest) return residual ? row.rest->equilibrium_residual.median : row.max_overlap;
  if (study.judged_by_horizon()) return study.right_until(row);
  return row.position_error;
}

/// Where heights of 0 are drawn, as a logarithmic axis has no place for them: a decade below all
/// others.  Absent: there are none.
std::optional<double> zero_line(const AccuracyStudy& study) {
  constexpr double kDecade = 10;
  bool zero = false;
  std::optional<double> least;
  for (const AccuracyRow& row : study.rows) {
    for (const bool residual : {true, false}) {
      const std::optional<double> height = height_of(study, row, residual);
      if (!height) continue;
      zero = zero || !(*height > 0);
      if (*height > 0 && (!least || *height < *least)) least = height;
    }
  }
  if (!zero) return std::nullopt;
  return least ? *least / kDecade : 1 / kDecade;
}

/// The points of the rows that are wanted, a line each.
template <class Wanted>
std::string points(const AccuracyStudy& study, const Wanted& wanted, bool residual = true) {
  const std::optional<double> zero = zero_line(study);
  std::string text;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const std::optional<double> height = height_of(study, study.rows[i], residual);
    const double seconds = study.seconds_per_simulated_second(study.rows[i]);
    if (!height || !(seconds > 0) || !wanted(i)) continue;
    text += *height > 0 ? fmt::format("{} {}\n", seconds, *height)
                        : fmt::format("{} {:.6g}\n", seconds, *zero);
  }
  return text;
}

/// Of a method: its line in double precision, or the rest.
std::string points_of(const AccuracyStudy& study, Method method, bool wide, bool residual = true) {
  return points(
      study,
      [&](std::size_t i) {
        return study.rows[i].method == method && (study.rows[i].digits > kDouble) == wide;
      },
      residual);
}

struct Series {
  std::string name;
  std::string points;
  std::string style;
};

std::vector<Series> series_of(const AccuracyStudy& study) {
  if (study.reference.equilibrium) {
    return {{"overlap: residual", points_of(study, Method::overlap, false),
             "with linespoints lw 2 pt 7 ps 1"},
            {"overlap: overlap", points_of(study, Method::overlap, false, false),
             "with linespoints lw 2 dt 2 pt 6 ps 1"},
            {"event: residual", points_of(study, Method::event, false),
             "with linespoints lw 2 pt 5 ps 1"},
            {"event: overlap", points_of(study, Method::event, false, false),
             "with linespoints lw 2 dt 2 pt 4 ps 1"}};
  }
  const std::vector<bool> best = best_choices(study);
  return {{"overlap", points_of(study, Method::overlap, false), "with linespoints lw 2 pt 7 ps 1"},
          {"event, 16 digits", points_of(study, Method::event, false),
           "with linespoints lw 2 pt 5 ps 1"},
          {"event, more digits", points_of(study, Method::event, true), "with points pt 9 ps 1.5"},
          {"Pareto front", points(study, [&](std::size_t i) { return best[i]; }),
           "with points pt 6 ps 2.5"}};
}

}  // namespace

std::string gnuplot_script(const AccuracyStudy& study, bool png) {
  std::vector<Series> series = series_of(study);
  std::erase_if(series, [](const Series& each) { return each.points.empty(); });
  std::string script =
      fmt::format("set terminal {}\n", png ? "pngcairo size 900,600" : "svg size 900,600");
  script += fmt::format("set title \"{} ({} balls, {:.6g} s)\" noenhanced\n", title_of(study),
                        study.balls, study.time);
  script +=
      "set logscale xy\nset format xy \"10^{%L}\"\nset grid\nset key outside bottom horizontal\n"
      "set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\n"
      "set xlabel \"wall-clock seconds per simulated second\"\n";
  const char* const what = study.reference.equilibrium ? "residual of equilibrium, and overlap"
                           : study.judged_by_horizon() ? "predictability horizon, s"
                                                       : "error of position at the end";
  script += fmt::format("set ylabel \"{}\"\n", what);
  if (const std::optional<double> zero = zero_line(study)) {
    script += fmt::format(
        "set ytics add (\"0 or less\" {0:.6g})\n"
        "set arrow from graph 0, first {0:.6g} to graph 1, first {0:.6g} nohead dt 2\n",
        *zero);
  }
  if (series.empty()) {
    return script + "set xrange [1:10]\nset yrange [1:10]\nplot NaN notitle\n";
  }
  for (std::size_t i = 0; i < series.size(); ++i) {
    script += fmt::format("$series{} << END\n{}END\n", i, series[i].points);
  }
  script += "plot ";
  for (std::size_t i = 0; i < series.size(); ++i) {
    script += fmt::format("{}$series{} {} title \"{}\"", i == 0 ? "" : ", ", i, series[i].style,
                          series[i].name);
  }
  return script + '\n';
}

Gnuplot::Gnuplot(const std::string& option, const std::string& file)
    : option_(option), png_(file.ends_with(".png")), file_(option, file) {
  if (!file.empty() && !is_installed("gnuplot")) {
    throw std::runtime_error(
        option + ": gnuplot draws it and is not installed; on Debian: apt-get install gnuplot-nox");
  }
}

void Gnuplot::draw(const AccuracyStudy& study) {
  if (!file_) return;
  file_.write(drawn(gnuplot_script(study, png_)));
}

}  // namespace carom
