#include "accuracy/rest_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "accuracy/announcer.hpp"
#include "accuracy/rest_run.hpp"
#include "accuracy/row.hpp"
#include "accuracy/samples.hpp"
#include "accuracy/scenario.hpp"

namespace carom::accuracy {
namespace {

using Clock = std::chrono::steady_clock;

/// A quantity over the starts: the median, and the range of the middle half.
class Distribution {
 public:
  void add(double value) { values_.push_back(value); }
  [[nodiscard]] std::size_t count() const { return values_.size(); }
  [[nodiscard]] MedianAndSpread summary() {
    std::sort(values_.begin(), values_.end());
    return {quantile(values_, 0.5), quantile(values_, 0.75) - quantile(values_, 0.25)};
  }
  [[nodiscard]] std::array<double, 2> quartiles() {
    std::sort(values_.begin(), values_.end());
    return {quantile(values_, 0.25), quantile(values_, 0.75)};
  }
  [[nodiscard]] std::array<double, 2> ends() const {
    const auto [least, most] = std::minmax_element(values_.begin(), values_.end());
    return {*least, *most};
  }

 private:
  std::vector<double> values_;
};

class RestStudy {
 public:
  RestStudy(const Scene& scene, const AccuracyRequest& request)
      : request_(request),
        announcer_(request),
        starts_(starts_of(scene, request.seeds, request.time)) {
    crew_ = request.crews.empty() ? AccuracyCrew{scene.per_ball, scene.workers.value_or(1)}
                                  : request.crews.front();
    study_.scene = scene.name;
    study_.time = starts_.front().end;
    study_.balls = starts_.front().start.balls.size();
    study_.seed = scene.seed;
    study_.starts = starts_.size();
    study_.drawn = !scene.fills.empty();
    study_.machine = this_machine();
    study_.target = request.target;
    study_.reference.equilibrium = true;
    for (const Ball& ball : starts_.front().start.balls) {
      study_.smallest_radius =
          study_.smallest_radius == 0 ? ball.radius : std::min(study_.smallest_radius, ball.radius);
    }
  }

  AccuracyStudy run() {
    plan_.push_back({Method::event, std::nullopt, 16});
    double step = kLongestStep;
    for (int count = 0; count < kSteps; ++count, step /= 2) {
      plan_.push_back({Method::overlap, step, 16});
    }
    try {
      for (std::size_t i = 0; i < plan_.size() && study_.sequence_end.empty(); ++i) run_planned(i);
    } catch (const StopAsked&) {
      study_.stopped = true;
    }
    study_.runs = study_.sequence_end.empty() ? plan_.size() : study_.rows.size();
    if (study_.target) study_.recommended = cheapest_within(study_, *study_.target);
    return std::move(study_);
  }

 private:
  /// What the rest of the plan is foreseen to take: from step to step up to twice as much.
  [[nodiscard]] double foreseen(std::size_t next) const {
    double left = 0;
    double run = last_;
    for (std::size_t i = next; i < plan_.size(); ++i) {
      if (plan_[i].step) run *= growth_;
      if (run > 2 * request_.share) break;
      left += run * static_cast<double>(starts_.size());
    }
    return left;
  }

  void run_planned(std::size_t number) {
    const Way& way = plan_[number];
    AccuracyRow row = new_row(way, crew_, study_.balls);
    fill_row(row, [&] { run_starts(row, way, number); });
    if (row.failure.empty()) {
      const bool stepped = last_step_ > 0 && row.step;
      growth_ = stepped && last_ > 0 ? std::clamp(row.seconds / last_, 1.0, 2.0) : 2.0;
      last_ = row.seconds;
      last_step_ = row.step.value_or(0);
    }
    study_.rows.push_back(row);
    if (request_.row_done) request_.row_done(study_.rows.back());
    if (!row.step || number + 1 == plan_.size()) return;
    study_.sequence_end = why_last(row, name_of(way), request_.share);
  }

  void run_starts(AccuracyRow& row, const Way& way, std::size_t number) {
    Distribution seconds;
    Distribution cpu;
    Distribution residual;
    Distribution creep;
    Distribution kinetic;
    Distribution rest_time;
    Distribution unexplained;
    Distribution overlap;
    Distribution ball_ball;
    Distribution ball_wall;
    Distribution height;
    for (std::size_t start = 0; start < starts_.size(); ++start) {
      const auto begun = Clock::now();
      const double later = foreseen(number + 1);
      const auto others = static_cast<double>(starts_.size() - start - 1);
      const RestRun run = run_to_rest(starts_[start], way, crew_, request_.share, [&](double part) {
        const double spent = std::chrono::duration<double>(Clock::now() - begun).count();
        const double whole = part > 0 ? spent / part : last_ * growth_;
        announcer_.tell(starts_.size() > 1 ? fmt::format("{}, start {} of {}", name_of(way),
                                                         start + 1, starts_.size())
                                           : name_of(way),
                        number + 1, plan_.size(), whole * (1 - part + others) + later);
      });
      row.workers = run.workers;
      seconds.add(run.seconds);
      cpu.add(run.cpu_seconds);
      residual.add(run.equilibrium_residual);
      creep.add(run.creep);
      kinetic.add(run.kinetic_energy);
      if (run.rest_time) rest_time.add(*run.rest_time);
      unexplained.add(run.dissipation_error);
      overlap.add(run.max_overlap);
      ball_ball.add(static_cast<double>(run.ball_ball));
      ball_wall.add(static_cast<double>(run.ball_wall));
      height.add(run.height);
    }
    row.seconds = seconds.summary().median;
    row.cpu_seconds = cpu.summary().median;
    row.quartiles = seconds.quartiles();
    row.fastest = seconds.ends()[0];
    row.slowest = seconds.ends()[1];
    row.repeats = seconds.count();
    row.max_overlap = overlap.summary().median;
    row.ball_ball = static_cast<std::uint64_t>(ball_ball.summary().median);
    row.ball_wall = static_cast<std::uint64_t>(ball_wall.summary().median);
    AccuracyRest rest;
    rest.equilibrium_residual = residual.summary();
    rest.creep = creep.summary();
    rest.kinetic_energy = kinetic.summary();
    // A start that never comes to rest has no time, and the median of the starts may have none.
    if (2 * rest_time.count() > starts_.size()) rest.rest_time = rest_time.summary();
    rest.dissipation_error = unexplained.summary();
    rest.height = height.summary();
    row.rest = rest;
  }

  const AccuracyRequest& request_;
  Announcer announcer_;
  std::vector<Scenario> starts_;
  AccuracyCrew crew_;
  std::vector<Way> plan_;
  double last_ = 0;       // seconds of a run of the row before
  double last_step_ = 0;  // its step; 0: none
  double growth_ = 2;     // from a step to the next
  AccuracyStudy study_;
};

}  // namespace

AccuracyStudy study_rest(const Scene& scene, const AccuracyRequest& request) {
  return RestStudy(scene, request).run();
}

}  // namespace carom::accuracy
