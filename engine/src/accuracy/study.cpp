#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>

#include "accuracy/assess.hpp"
#include "accuracy/remaining.hpp"
#include "accuracy/scenario.hpp"
#include "accuracy/timing.hpp"
#include "accuracy/truth.hpp"
#include "carom/accuracy.hpp"
#include "carom/scene_file.hpp"

namespace carom {
namespace accuracy {
namespace {

constexpr double kReferenceShares = 15;                   // that the reference may take
constexpr std::size_t kMostBytes = std::size_t{1} << 28;  // of the truth's places
constexpr std::size_t kBytesOfBall = 256;  // with 100 digits, and what keeping them takes
constexpr double kTimesRun = 6;  // a row is run so often, foreseen: assessed, refined, timed

class Study {
 public:
  Study(const Scene& scene, const AccuracyRequest& request)
      : request_(request),
        scenario_(scenario_of(scene, request.time)),
        crews_(request.crews),
        radius_(smallest_radius(scenario_.start.balls)),
        samples_(scenario_.end, kMostBytes / kBytesOfBall /
                                    std::max<std::size_t>(1, scenario_.start.balls.size())),
        remaining_(request.progress) {
    if (crews_.empty()) crews_.push_back({scene.per_ball, scene.workers.value_or(1)});
    study_.scene = scene.name;
    study_.time = scenario_.end;
    study_.balls = scenario_.start.balls.size();
    study_.smallest_radius = radius_;
    study_.seed = scene.seed;
    study_.machine = this_machine();
    study_.target = request.target;
  }

  AccuracyStudy run() {
    find_reference();
    if (scenario_.start.effects.attraction) {
      climb_down(Method::event);
    } else {
      run_row(Method::event, std::nullopt, 16);
    }
    for (const int digits : {34, 50}) run_row(Method::event, std::nullopt, digits);
    climb_down(Method::overlap);
    for (std::size_t crew = 1; crew < crews_.size(); ++crew) run_on(crews_[crew]);
    refine();
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

  [[nodiscard]] static std::string name_of(const AccuracyRow& row) {
    return row.step ? fmt::format("{} at 1/{:.5g} s",
                                  row.method == Method::event ? "event" : "overlap", 1 / *row.step)
                    : fmt::format("event with {} digits", row.digits);
  }

  /// What the whole ladder is foreseen to take, before anything is known of it.
  [[nodiscard]] double foreseen() const { return 2 * kTimesRun * request_.share / 2; }

  void find_reference() {
    const auto told = [this, started = std::chrono::steady_clock::now()](double part) {
      const double spent =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
      remaining_.tell(spent / part - spent + foreseen(), "reference");
    };
    remaining_.tell(foreseen(), "reference");
    truth_ = find_truth(scenario_, samples_, radius_, kReferenceShares * request_.share, told);
  }

  AccuracyRow new_row(Method method, std::optional<double> step, int digits,
                      const AccuracyCrew& crew) const {
    AccuracyRow row;
    row.method = method;
    row.step = step;
    row.digits = digits;
    row.per_ball = crew.per_ball;
    row.workers = crew.per_ball ? std::max<std::size_t>(1, study_.balls) : crew.workers;
    return row;
  }

  /// A run that fails is a row that says so.
  const AccuracyRow& run_row(Method method, std::optional<double> step, int digits) {
    AccuracyRow row = new_row(method, step, digits, crews_.front());
    remaining_.tell(std::max(0.1, left_), name_of(row));
    std::optional<Loss> loss;
    try {
      if (method == Method::event && !truth_.reference.step && digits >= truth_.reference.digits) {
        throw TooLong("there is no wider run to hold it against within the time it may take");
      }
      loss = assess(row, scenario_, samples_, truth_, radius_);
      time_runs(row, scenario_, crews_.front(), request_.share);
    } catch (const SceneError& error) {
      row.failure = error.problems().front().place + ": " + error.problems().front().message;
    } catch (const std::exception& error) {
      row.failure = error.what();
    }
    if (!row.failure.empty()) loss.reset();
    if (loss) losses_[study_.rows.size()] = *loss;
    study_.rows.push_back(std::move(row));
    return study_.rows.back();
  }

  /// The ladder of steps, down to the run that takes more than its share.
  void climb_down(Method method) {
    double step = kLongestStep;
    double before = 0;
    for (int rung = 0; rung < kRungs; ++rung, step /= 2) {
      // What the rungs to come would take, each twice the one before up to a share.
      left_ = 0;
      double next = 2 * before;
      for (int later = rung; later < kRungs && next < 2 * request_.share; ++later, next *= 2) {
        left_ += kTimesRun * next;
      }
      const AccuracyRow& row = run_row(method, step, 16);
      if (!row.failure.empty()) {
        end_ladder(fmt::format("{}: {}", name_of(row), row.failure));
        return;
      }
      before = row.seconds;
      if (before > request_.share && rung + 1 < kRungs) {
        end_ladder(
            fmt::format("{} took {:.3g} s, and the share of a run is {:.3g} s; --share gives more",
                        name_of(row), before, request_.share));
        return;
      }
    }
  }

  void end_ladder(const std::string& why) {
    study_.ladder_end += (study_.ladder_end.empty() ? "" : "; ") + why;
  }

  /// The same runs on another crew: one of each method, in steps that of the scene or the rung
  /// below.
  void run_on(const AccuracyCrew& crew) {
    const double wanted = scenario_.start.solver.step;
    const std::size_t count = study_.rows.size();
    for (const Method method : {Method::event, Method::overlap}) {
      std::optional<std::size_t> chosen;
      for (std::size_t i = 0; i < count; ++i) {
        const AccuracyRow& row = study_.rows[i];
        if (row.method != method || !row.failure.empty() || same_run_.contains(i)) continue;
        const bool too_long = chosen && study_.rows[*chosen].step.value_or(0) > wanted;
        if (!chosen || too_long) chosen = i;
      }
      if (chosen) run_on(crew, *chosen);
    }
  }

  void run_on(const AccuracyCrew& crew, std::size_t number) {
    AccuracyRow row = study_.rows[number];
    if (!row.failure.empty()) return;
    row.per_ball = crew.per_ball;
    row.workers = crew.per_ball ? std::max<std::size_t>(1, study_.balls) : crew.workers;
    remaining_.tell(kTimesRun * row.seconds, name_of(row) + " on another crew");
    try {
      time_runs(row, scenario_, crew, request_.share);
    } catch (const std::exception& error) {
      row.failure = error.what();
    }
    same_run_[study_.rows.size()] = number;
    study_.rows.push_back(std::move(row));
  }

  /// Looks closer at when each run was lost.
  void refine() {
    for (const auto& [row, loss] : losses_) {
      for (const std::uint64_t fine : fine_numbers(study_.rows[row], loss, samples_)) {
        truth_.at_fine.try_emplace(fine);
      }
    }
    if (truth_.at_fine.empty()) return;
    const double whole = truth_.reference.seconds;
    refine_truth(truth_, scenario_, samples_,
                 [&](double part) { remaining_.tell((1 - part) * whole, "horizons"); });
    for (const auto& [number, loss] : losses_) {
      AccuracyRow& row = study_.rows[number];
      remaining_.tell(row.seconds, "horizons");
      refine_horizon(row, loss, scenario_, samples_, truth_, radius_);
    }
    for (const auto& [number, same] : same_run_) {
      study_.rows[number].horizon = study_.rows[same].horizon;
      study_.rows[number].horizon_resolution = study_.rows[same].horizon_resolution;
    }
  }

  const AccuracyRequest& request_;
  Scenario scenario_;
  std::vector<AccuracyCrew> crews_;
  double radius_;
  Samples samples_;
  Remaining remaining_;
  double left_ = 0;
  Truth truth_;
  std::map<std::size_t, Loss> losses_;           // of rows
  std::map<std::size_t, std::size_t> same_run_;  // of rows: the same on the first crew
  AccuracyStudy study_;
};

}  // namespace
}  // namespace accuracy

AccuracyStudy study_accuracy(const Scene& scene, const AccuracyRequest& request) {
  return accuracy::Study(scene, request).run();
}

}  // namespace carom
