#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "accuracy/announcer.hpp"
#include "accuracy/assess.hpp"
#include "accuracy/averages.hpp"
#include "accuracy/forecast.hpp"
#include "accuracy/rest_study.hpp"
#include "accuracy/scenario.hpp"
#include "accuracy/timing.hpp"
#include "accuracy/truth.hpp"
#include "carom/accuracy.hpp"
#include "carom/scene_file.hpp"

namespace carom {
namespace accuracy {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kReferenceLimits = 15;                   // that the reference may take
constexpr std::size_t kMostBytes = std::size_t{1} << 28;  // of the reference's positions
constexpr std::size_t kBytesOfBall = 256;  // with 100 digits, and what keeping them takes
constexpr double kRefined = 0.3;           // of the reference, foreseen for sharper horizons

constexpr double kAveragedLimits = 5;  // that the runs of a row that are averaged may take

/// A run that is planned.
struct Planned {
  Way way;
  AccuracyCrew crew;
  /// Where it is a row's run on another crew: the row.
  std::optional<std::size_t> same;
};

class Study {
 public:
  Study(const Scene& scene, const AccuracyRequest& request)
      : request_(request),
        announcer_(request),
        scenario_(scenario_of(scene, request.time)),
        crews_(request.crews),
        radius_(smallest_radius(scenario_.start.balls)),
        samples_(scenario_.end, kMostBytes / kBytesOfBall /
                                    std::max<std::size_t>(1, scenario_.start.balls.size())),
        forecast_(scenario_, request.share) {
    if (crews_.empty()) crews_.push_back({scene.per_ball, scene.workers.value_or(1)});
    study_.scene = scene.name;
    study_.time = scenario_.end;
    study_.balls = scenario_.start.balls.size();
    study_.smallest_radius = radius_;
    study_.seed = scene.seed;
    study_.machine = this_machine();
    study_.target = request.target;
    find_starts(scene, request);
  }

  AccuracyStudy run() {
    plan();
    try {
      find_reference();
      find_reference_averages();
      for (at_ = 0; at_ < plan_.size(); ++at_) run_planned();
      plan_other_crews();
      for (; at_ < plan_.size(); ++at_) run_on_other_crew();
      refine();
    } catch (const StopAsked&) {
      study_.stopped = true;
    }
    study_.runs = plan_.size();
    study_.reference = truth_.reference;
    if (study_.target) study_.recommended = cheapest_within(study_, *study_.target);
    return std::move(study_);
  }

 private:
  static double smallest_radius(const std::vector<Ball>& balls) {
    double radius = balls.empty() ? 0 : balls.front().radius;
    for (const Ball& ball : balls) radius = std::min(radius, ball.radius);
    return radius;
  }

  void plan() {
    const AccuracyCrew& crew = crews_.front();
    const auto plan_steps = [&](Method method) {
      double step = kLongestStep;
      for (int count = 0; count < kSteps; ++count, step /= 2) {
        plan_.push_back({{method, step, 16}, crew, {}});
      }
    };
    if (scenario_.start.effects.attraction) {
      plan_steps(Method::event);
    } else {
      plan_.push_back({{Method::event, std::nullopt, 16}, crew, {}});
    }
    for (const int digits : {34, 50}) {
      plan_.push_back({{Method::event, std::nullopt, digits}, crew, {}});
    }
    plan_steps(Method::overlap);
    unplanned_ = 2 * (crews_.size() - 1);
  }

  void tell(const std::string& what, std::size_t run, double left) {
    announcer_.tell(what, run, plan_.size() + unplanned_, left);
  }

  /// What the planned runs from `next` on and the horizons are foreseen to take.
  [[nodiscard]] double foreseen(std::size_t next) const {
    double left = 0;
    for (std::size_t i = next; i < plan_.size(); ++i) {
      const double run = forecast_.run(plan_[i].way);
      if (plan_[i].way.step && run > 2 * request_.share) continue;  // it will be left out
      left += plan_[i].same ? forecast_.with_repeats(run) - run : forecast_.with_repeats(run);
    }
    if (truth_.reference.seconds > 0 && losses_.empty()) return left;
    const double reference =
        truth_.reference.seconds > 0 ? truth_.reference.seconds : forecast_.reference();
    return left + kRefined * reference;
  }

  void find_reference() {
    tell("reference", 0, forecast_.reference() + foreseen(0));
    try {
      truth_ = find_truth(scenario_, samples_, radius_, kReferenceLimits * request_.share,
                          [this](double spent, double whole) {
                            forecast_.learn_reference(whole, 100);
                            tell("reference", 0, std::max(0.0, whole - spent) + foreseen(0));
                          });
    } catch (const NoReference& none) {
      if (study_.observables.empty()) throw;
      truth_ = {};
      truth_.reference.absent = none.what();
      truth_.reference.holds_until = 0;
      return;
    }
    forecast_.learn_reference(truth_.reference.seconds, truth_.reference.digits);
  }

  /// The starts whose runs are averaged, one where nothing is drawn from the seed.
  void find_starts(const Scene& scene, const AccuracyRequest& request) {
    if (request.observables.empty()) return;
    study_.observables = request.observables;
    study_.starts = scene.fills.empty() ? 1 : std::max<std::size_t>(1, request.seeds);
    Scene drawn = scene;
    for (std::size_t i = 0; i < study_.starts; ++i) {
      drawn.seed = scene.seed + i;
      starts_.push_back(scenario_of(drawn, request.time));
    }
  }

  /// The averages of a way over the starts.
  std::vector<std::optional<MeanAndError>> average(const Way& way, const AccuracyCrew& crew,
                                                   std::size_t run, double later) {
    std::vector<Averages> runs;
    const double once = forecast_.run(way);
    for (std::size_t start = 0; start < starts_.size(); ++start) {
      runs.push_back(averages_of(study_.observables, starts_[start], way, crew, [&](double part) {
        const double left = once * (static_cast<double>(starts_.size() - start) - part);
        tell(fmt::format("averages of {}, start {} of {}", name_of(way), start + 1, starts_.size()),
             run, left + later);
      }));
    }
    return mean_over(runs);
  }

  void find_reference_averages() {
    if (study_.observables.empty()) return;
    Way way{Method::event, truth_.reference.step, 16};
    if (!way.step && is_averaged(forecast_.run({Method::event, {}, 34}))) way.digits = 34;
    study_.average_digits = way.digits;
    study_.averages = average(way, crews_.front(), 0, foreseen(0));
  }

  [[nodiscard]] bool is_reference_of_averages(const Way& way) const {
    return way.method == Method::event && !way.step && !truth_.reference.step &&
           way.digits == study_.average_digits;
  }

  /// Whether runs of so many seconds are done from all starts.
  [[nodiscard]] bool is_averaged(double run) const {
    return run * static_cast<double>(starts_.size()) <= kAveragedLimits * request_.share;
  }

  static AccuracyRow new_row(const Planned& planned, std::size_t balls) {
    AccuracyRow row;
    row.method = planned.way.method;
    row.step = planned.way.step;
    row.digits = planned.way.digits;
    row.per_ball = planned.crew.per_ball;
    row.workers = planned.crew.per_ball ? std::max<std::size_t>(1, balls) : planned.crew.workers;
    return row;
  }

  /// A run that fails is a row that says so.
  void run_planned() {
    const Planned planned = plan_[at_];
    AccuracyRow row = new_row(planned, study_.balls);
    const auto started = Clock::now();
    const double later = foreseen(at_ + 1);
    const double mine = forecast_.row(planned.way);
    const Stopped stopped = [&] {
      const double spent = std::chrono::duration<double>(Clock::now() - started).count();
      tell(name_of(planned.way), at_ + 1, std::max(0.0, mine - spent) + later);
      return false;
    };
    (void)stopped();
    std::optional<Loss> loss;
    try {
      if (row.method == Method::event && !truth_.reference.step &&
          truth_.reference.absent.empty() && row.digits >= truth_.reference.digits) {
        throw TooLong("there is no run with more digits to compare it with in the time limit");
      }
      loss = assess(row, scenario_, samples_, truth_, radius_, stopped);
      time_runs(row, scenario_, planned.crew, request_.share, stopped);
      if (!study_.observables.empty() && is_averaged(row.seconds)) {
        // The reference's averages are those of this run, where it has as many digits.
        row.averages = is_reference_of_averages(planned.way)
                           ? study_.averages
                           : average(planned.way, planned.crew, at_ + 1, later);
      }
    } catch (const StopAsked&) {
      throw;
    } catch (const SceneError& error) {
      row.failure = error.problems().front().place + ": " + error.problems().front().message;
    } catch (const std::exception& error) {
      row.failure = error.what();
    }
    if (!row.failure.empty()) loss.reset();
    if (loss) losses_[study_.rows.size()] = *loss;
    finish(std::move(row));
    if (study_.rows.back().step) end_steps_where_too_long(study_.rows.back());
  }

  void finish(AccuracyRow row) {
    forecast_.learn(row);
    study_.rows.push_back(std::move(row));
    if (request_.row_done) request_.row_done(study_.rows.back());
  }

  /// After a run that takes more than the time limit no shorter steps are tried.
  void end_steps_where_too_long(const AccuracyRow& row) {
    const auto is_shorter = [&](const Planned& planned) {
      return planned.way.method == row.method && planned.way.step && *planned.way.step < *row.step;
    };
    const auto rest = plan_.begin() + static_cast<std::ptrdiff_t>(at_) + 1;
    if (std::none_of(rest, plan_.end(), is_shorter)) return;
    const std::string name = name_of(plan_[at_].way);
    std::string why;
    if (!row.failure.empty()) {
      why = fmt::format("{}: {}", name, row.failure);
    } else if (row.seconds > request_.share) {
      why = fmt::format(
          "{} took {:.3g} s, and the time limit of a run is {:.3g} s; --share raises it", name,
          row.seconds, request_.share);
    } else {
      return;
    }
    study_.ladder_end += (study_.ladder_end.empty() ? "" : "; ") + why;
    plan_.erase(std::remove_if(rest, plan_.end(), is_shorter), plan_.end());
  }

  /// The same runs on the other crews: one of each method, in steps that of the scene or the next
  /// shorter.
  void plan_other_crews() {
    const double wanted = scenario_.start.solver.step;
    unplanned_ = 0;
    for (std::size_t crew = 1; crew < crews_.size(); ++crew) {
      for (const Method method : {Method::event, Method::overlap}) {
        std::optional<std::size_t> chosen;
        for (std::size_t i = 0; i < study_.rows.size(); ++i) {
          const AccuracyRow& row = study_.rows[i];
          if (row.method != method || !row.failure.empty()) continue;
          const bool too_long = chosen && study_.rows[*chosen].step.value_or(0) > wanted;
          if (!chosen || too_long) chosen = i;
        }
        if (!chosen) continue;
        const AccuracyRow& row = study_.rows[*chosen];
        plan_.push_back({{row.method, row.step, row.digits}, crews_[crew], chosen});
      }
    }
  }

  void run_on_other_crew() {
    const Planned& planned = plan_[at_];
    AccuracyRow row = study_.rows[*planned.same];
    row.per_ball = planned.crew.per_ball;
    row.workers =
        planned.crew.per_ball ? std::max<std::size_t>(1, study_.balls) : planned.crew.workers;
    const Stopped stopped = [&] {
      tell(name_of(planned.way) + " on other workers", at_ + 1, foreseen(at_));
      return false;
    };
    (void)stopped();
    try {
      time_runs(row, scenario_, planned.crew, request_.share, stopped);
    } catch (const StopAsked&) {
      throw;
    } catch (const std::exception& error) {
      row.failure = error.what();
    }
    same_run_[study_.rows.size()] = *planned.same;
    study_.rows.push_back(std::move(row));
    if (request_.row_done) request_.row_done(study_.rows.back());
  }

  /// Looks closer at when each run was lost.
  void refine() {
    for (const auto& [row, loss] : losses_) {
      for (const std::uint64_t fine : fine_numbers(study_.rows[row], loss, samples_)) {
        truth_.at_fine.try_emplace(fine);
      }
    }
    if (truth_.at_fine.empty()) return;
    double runs = 0;
    for (const auto& [row, loss] : losses_) runs += study_.rows[row].seconds;
    refine_truth(truth_, scenario_, samples_, [&](double spent, double whole) {
      tell("predictability horizons", 0, std::max(0.0, whole - spent) + runs);
    });
    for (const auto& [number, loss] : losses_) {
      AccuracyRow& row = study_.rows[number];
      refine_horizon(row, loss, scenario_, samples_, truth_, radius_, [&] {
        tell("predictability horizons", 0, runs);
        return false;
      });
      runs -= row.seconds;
    }
    for (const auto& [number, same] : same_run_) {
      study_.rows[number].horizon = study_.rows[same].horizon;
      study_.rows[number].horizon_resolution = study_.rows[same].horizon_resolution;
    }
  }

  const AccuracyRequest& request_;
  Announcer announcer_;
  Scenario scenario_;
  std::vector<Scenario> starts_;  // of runs that are averaged
  std::vector<AccuracyCrew> crews_;
  double radius_;
  Samples samples_;
  Forecast forecast_;
  std::vector<Planned> plan_;
  std::size_t at_ = 0;         // in the plan
  std::size_t unplanned_ = 0;  // runs on other crews, two each, until it is known which
  Truth truth_;
  std::map<std::size_t, Loss> losses_;           // of rows
  std::map<std::size_t, std::size_t> same_run_;  // of rows: the same on the first crew
  AccuracyStudy study_;
};

}  // namespace
}  // namespace accuracy

AccuracyStudy study_accuracy(const Scene& scene, const AccuracyRequest& request) {
  if (comes_to_rest(scene)) return accuracy::study_rest(scene, request);
  return accuracy::Study(scene, request).run();
}

}  // namespace carom
