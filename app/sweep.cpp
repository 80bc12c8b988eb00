#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "carom/report.hpp"
#include "carom/scene_change.hpp"
#include "carom/scene_file.hpp"
#include "commands.hpp"
#include "progress.hpp"
#include "scene_files.hpp"
#include "standard_streams.hpp"
#include "sweep/axis.hpp"
#include "sweep/child.hpp"
#include "sweep/folder.hpp"
#include "sweep/point_report.hpp"
#include "sweep/share.hpp"

namespace carom {
namespace {

using sweeps::Axis;
using sweeps::Child;
using sweeps::Folder;
using sweeps::Plan;
using sweeps::TaskShare;
using Clock = std::chrono::steady_clock;

/// The options of run that the points get, as they are given.
std::vector<std::string> options_of_run(const Options& options) {
  std::vector<std::string> words;
  const auto add = [&](const char* name, const std::string& value) {
    words.emplace_back(name);
    words.push_back(value);
  };
  if (options.method) add("--method", method_name(*options.method));
  if (options.step) add("--step", fmt::format("{}", *options.step));
  if (options.digits) add("--digits", fmt::format("{}", *options.digits));
  if (options.seed) add("--seed", fmt::format("{}", *options.seed));
  if (options.time) add("--time", fmt::format("{}", *options.time));
  if (options.frames) add("--frames", fmt::format("{}", *options.frames));
  for (const std::string& change : options.set) add("--set", change);
  return words;
}

/// An axis none of whose values the scene takes changes something that is not there.
void check_axes(const Plan& plan, const Options& options) {
  for (const Axis& axis : plan.axes) {
    std::string why;
    const bool good =
        std::any_of(axis.values.begin(), axis.values.end(), [&](const std::string& value) {
          try {
            std::vector<SceneChange> changes;
            for (const std::string& text : options.set) changes.push_back(parse_change(text));
            changes.push_back(parse_change(axis.pointer + '=' + value));
            (void)parse_scene(plan.scene, options.scenes.front(), changes);
            return true;
          } catch (const SceneError& error) {
            const Problem& problem = error.problems().front();
            why = (problem.place == axis.pointer || problem.place.empty() ? ""
                                                                          : problem.place + ": ") +
                  problem.message;
          } catch (const std::invalid_argument& error) {
            why = error.what();
          }
          return false;
        });
    if (!good) throw UsageError(fmt::format("--over {}: {}", axis.pointer, why));
  }
}

/// What the file says, word for word.
std::string text_of_scene(const std::string& name) {
  const std::filesystem::path file = find_scene(name);
  if (name == "-") return {std::istreambuf_iterator<char>(std::cin), {}};
  (void)read_scene(file, {});  // says what is wrong with it, or that it is not there
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void check_arguments(const Options& options) {
  const bool looks = options.status || options.merge;
  const std::size_t wanted = looks ? 1 : 2;
  if (options.scenes.size() != wanted) {
    throw UsageError(looks ? "sweep --status and --merge take one DIR"
                           : "sweep needs a SCENE and a DIR; see carom sweep --help");
  }
  if (looks && !options.over.empty()) {
    throw UsageError("--over: not with --status or --merge, which take what DIR says");
  }
  if (!options.sweep_share.empty() && options.jobs) {
    throw UsageError("--share and --jobs: give one of them; a share runs one point at a time");
  }
}

TaskShare share_of(const Options& options) {
  if (!options.sweep_share.empty()) return sweeps::parse_share(options.sweep_share);
  return sweeps::share_of_environment([](const char* name) -> std::optional<std::string> {
    const char* const value = std::getenv(name);
    return value == nullptr ? std::nullopt : std::optional<std::string>(value);
  });
}

struct Counts {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t open = 0;
};

Counts count(const Folder& folder, std::size_t points) {
  Counts counts;
  for (std::size_t point = 0; point < points; ++point) {
    switch (folder.state(point)) {
      case Folder::State::done:
        ++counts.done;
        break;
      case Folder::State::failed:
        ++counts.failed;
        break;
      default:
        ++counts.open;
    }
  }
  return counts;
}

void merge(const Folder& folder, const Plan& plan) {
  std::vector<std::string> reports(sweeps::count_points(plan.axes));
  for (std::size_t point = 0; point < reports.size(); ++point) {
    if (folder.state(point) == Folder::State::done) reports[point] = folder.report(point);
  }
  folder.put("runs.csv", sweeps::runs_csv(plan.axes, reports));
  folder.put("summary.csv", sweeps::summary_csv(plan.axes, reports));
}

/// Runs the points of a share, several processes at a time.
class Runner {
 public:
  Runner(const Folder& folder, const Plan& plan, const Options& options)
      : folder_(folder), plan_(plan), options_(options), progress_(!options.quiet) {}

  void run(const TaskShare& share, std::size_t jobs) {
    std::deque<std::size_t> points;
    const std::size_t all = sweeps::count_points(plan_.axes);
    for (std::size_t point = 0; point < all; ++point) {
      if (!share.owns(point)) continue;
      const Folder::State state = folder_.state(point);
      if (state == Folder::State::open || (state == Folder::State::failed && options_.retry)) {
        points.push_back(point);
      } else {
        ++there_;
      }
    }
    const std::size_t wanted = points.size();
    while (!points.empty() || !running_.empty()) {
      while (!points.empty() && running_.size() < jobs) {
        start(points.front());
        points.pop_front();
      }
      finish_one();
      const auto over = static_cast<double>(done_ + failed_);
      const double spent = std::chrono::duration<double>(Clock::now() - began_).count();
      progress_.show_left(
          over / static_cast<double>(wanted), spent / over * (static_cast<double>(wanted) - over),
          fmt::format("{} of {} points, {} failed", done_ + failed_, wanted, failed_));
    }
    progress_.erase();
  }

  [[nodiscard]] std::size_t done() const { return done_; }
  [[nodiscard]] std::size_t there() const { return there_; }
  [[nodiscard]] std::size_t failed() const { return failed_; }

 private:
  void start(std::size_t point) {
    std::vector<std::string> words{"carom",      "run",     "-",        "--report",       "-",
                                   "--no-state", "--quiet", "--series", Child::kThirdFile};
    words.insert(words.end(), plan_.options.begin(), plan_.options.end());
    // Of other runs at the same time each is best off with one core.
    words.insert(words.end(), {"--workers", options_.workers.value_or("1")});
    const std::vector<std::string> values = sweeps::values_of(plan_.axes, point);
    for (std::size_t k = 0; k < values.size(); ++k) {
      words.insert(words.end(), {"--set", plan_.axes[k].pointer + '=' + values[k]});
    }
    Child child(words, plan_.scene);
    const int process = child.process();
    running_.emplace(process, std::pair(point, std::move(child)));
  }

  void finish_one() {
    int status = 0;
    const pid_t process = waitpid(-1, &status, 0);
    if (process < 0) {
      if (errno == EINTR) return;
      throw std::system_error(errno, std::generic_category(), "waiting for a run");
    }
    const auto found = running_.find(process);
    if (found == running_.end()) return;
    auto& [point, child] = found->second;
    const Child::Outcome outcome = child.outcome(status);
    if (outcome.good) {
      folder_.put_report(point, sweeps::point_report(outcome.out, outcome.third, plan_.axes,
                                                     sweeps::values_of(plan_.axes, point)));
      ++done_;
    } else {
      folder_.put_failure(point, outcome.err.empty() ? outcome.how + '\n' : outcome.err);
      ++failed_;
    }
    running_.erase(found);
  }

  const Folder& folder_;
  const Plan& plan_;
  const Options& options_;
  Progress progress_;
  Clock::time_point began_ = Clock::now();
  std::map<pid_t, std::pair<std::size_t, Child>> running_;
  std::size_t done_ = 0;
  std::size_t there_ = 0;
  std::size_t failed_ = 0;
};

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

void list_failures(const Folder& folder, std::size_t points) {
  for (std::size_t point = 0; point < points; ++point) {
    if (folder.state(point) != Folder::State::failed) continue;
    print(fmt::format("failed: {:06}: {}\n", point, first_line(folder.failure(point))));
  }
}

int report_on(const Options& options) {
  const Folder folder(options.scenes.front());
  const Plan plan = folder.plan();
  const std::size_t points = sweeps::count_points(plan.axes);
  const Counts counts = count(folder, points);
  if (options.merge) merge(folder, plan);
  print(fmt::format("{} points: {} done, {} failed, {} open{}\n", points, counts.done,
                    counts.failed, counts.open,
                    options.merge ? fmt::format("; wrote {}/runs.csv and {}/summary.csv",
                                                folder.path().string(), folder.path().string())
                                  : ""));
  list_failures(folder, points);
  return 0;
}

}  // namespace

int sweep(const Options& options) {
  check_arguments(options);
  if (options.status || options.merge) return report_on(options);
  Plan plan;
  plan.version = version();
  for (const std::string& text : options.over) plan.axes.push_back(sweeps::parse_axis(text));
  for (std::size_t k = 0; k < plan.axes.size(); ++k) {
    for (std::size_t m = 0; m < k; ++m) {
      if (plan.axes[k].pointer != plan.axes[m].pointer) continue;
      throw UsageError(fmt::format("--over {}: given twice", plan.axes[k].pointer));
    }
  }
  const std::size_t points = sweeps::count_points(plan.axes);
  const TaskShare share = share_of(options);
  plan.options = options_of_run(options);
  plan.scene = text_of_scene(options.scenes.front());
  (void)parse_scene(plan.scene, options.scenes.front());
  check_axes(plan, options);

  const Folder folder(options.scenes.back());
  folder.begin(plan);
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t jobs =
      share.from.empty() ? static_cast<std::size_t>(options.jobs.value_or(cores)) : 1;
  Runner runner(folder, plan, options);
  runner.run(share, jobs);

  // The last task to end writes the tables; where two do, they write the same.
  const Counts counts = count(folder, points);
  if (counts.open == 0) {
    folder.tidy();
    merge(folder, plan);
  }
  if (!options.quiet) {
    print(
        fmt::format("share {}/{}{}: {} run, {} already done, {} failed; {} of all {} points are "
                    "open\n",
                    share.index, share.count, share.from.empty() ? "" : ", from " + share.from,
                    runner.done(), runner.there(), runner.failed(), counts.open, points));
    if (counts.open == 0) {
      print(fmt::format("wrote {0}/runs.csv and {0}/summary.csv\n", folder.path().string()));
    }
    list_failures(folder, points);
  }
  return counts.failed > 0 ? 1 : 0;
}

}  // namespace carom
