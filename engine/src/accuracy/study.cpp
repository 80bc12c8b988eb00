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
#include "accuracy/row.hpp"
#include "accuracy/scenario.hpp"
#include "accuracy/study_plan.hpp"
#include "accuracy/timing.hpp"
#include "accuracy/truth.hpp"
#include "carom/accuracy.hpp"

namespace carom {
namespace accuracy {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kReferenceLimits = 15;                   // that the reference may take
constexpr std::size_t kMostBytes = std::size_t{1} << 28;  // of the reference's positions
constexpr std::size_t kBytesOfBall = 256;  // with 100 digits, and what keeping them takes
constexpr double kRefined = 0.3;           // of the reference, foreseen for sharper horizons

constexpr double kAveragedLimits = 5;  // that the runs of a row that are averaged may take

class Study {
 public:
  Study(const Scene& scene, const AccuracyRequest& request)
      : request_(request),
        announcer_(request),
        scenario_(scenario_of(scene, request.time)),
        crews_(crews_of(scene, request)),
        radius_(smallest_radius(scenario_.start.balls)),
        samples_(scenario_.end, kMostBytes / kBytesOfBall /
                                    std::max<std::size_t>(1, scenario_.start.balls.size())),
        forecast_(scenario_, request.share),
        plan_(scenario_, crews_) {
    study_.scene = scene.name;
    study_.time = scenario_.end;
    study_.balls = scenario_.start.balls.size();
    study_.smallest_radius = radius_;
    study_.seed = scene.seed;
    study_.drawn = !scene.fills.empty();
    study_.machine = this_machine();
    study_.target = request.target;
    if (request.observables.empty()) return;
    study_.observables = request.observables;
    starts_ = starts_of(scene, request.seeds, request.time);
    study_.starts = starts_.size();
  }

  AccuracyStudy run() {
    try {
      find_reference();
      find_reference_averages();
      for (at_ = 0; at_ < plan_.size(); ++at_) run_planned();
      plan_.add_other_crews(study_.rows, scenario_.start.solver.step);
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
  static std::vector<AccuracyCrew> crews_of(const Scene& scene, const AccuracyRequest& request) {
    if (!request.crews.empty()) return request.crews;
    return {{scene.per_ball, scene.workers.value_or(1)}};
  }

  static double smallest_radius(const std::vector<Ball>& balls) {
    double radius = balls.empty() ? 0 : balls.front().radius;
    for (const Ball& ball : balls) radius = std::min(radius, ball.radius);
    return radius;
  }

  void tell(const std::string& what, std::size_t run, double left) {
    announcer_.tell(what, run, plan_.expected(), left);
  }

  /// What the planned runs from `next` on and the horizons are foreseen to take.
  [[nodiscard]] double foreseen(std::size_t next) const {
    const double left = plan_.seconds(next, forecast_, request_.share);
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

  /// A run that fails is a row that says so.
  void run_planned() {
    const Planned planned = plan_[at_];
    AccuracyRow row = new_row(planned.way, planned.crew, study_.balls);
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
    fill_row(row, [&] {
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
    });
    if (!row.failure.empty()) loss.reset();
    if (loss) losses_[study_.rows.size()] = *loss;
    finish(std::move(row));
    end_steps_where_too_long();
  }

  void finish(AccuracyRow row) {
    forecast_.learn(row);
    study_.rows.push_back(std::move(row));
    if (request_.row_done) request_.row_done(study_.rows.back());
  }

  /// After a run that takes more than the time limit no shorter steps are tried.
  void end_steps_where_too_long() {
    if (!plan_.goes_on_with_shorter_steps(at_)) return;
    const std::string why = why_last(study_.rows.back(), name_of(plan_[at_].way), request_.share);
    if (why.empty()) return;
    study_.sequence_end += (study_.sequence_end.empty() ? "" : "; ") + why;
    plan_.leave_out_shorter_steps(at_);
  }

  void run_on_other_crew() {
    const Planned& planned = plan_[at_];
    AccuracyRow row = study_.rows[*planned.same];
    const AccuracyRow on_crew = new_row(planned.way, planned.crew, study_.balls);
    row.per_ball = on_crew.per_ball;
    row.workers = on_crew.workers;
    const Stopped stopped = [&] {
      tell(name_of(planned.way) + " on other workers", at_ + 1, foreseen(at_));
      return false;
    };
    (void)stopped();
    fill_row(row, [&] { time_runs(row, scenario_, planned.crew, request_.share, stopped); });
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
  StudyPlan plan_;
  std::size_t at_ = 0;  // in the plan
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
