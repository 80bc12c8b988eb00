#include "accuracy/averages.hpp"

#include <cmath>

#include "carom/fluid.hpp"

namespace carom::accuracy {
namespace {

constexpr std::size_t kSamples = 200;
constexpr std::size_t kForgotten = kSamples / 5;

/// Of the balls that can move.
double mean_speed(const std::vector<Ball>& balls) {
  double sum = 0;
  double count = 0;
  for (const Ball& ball : balls) {
    if (ball.fixed) continue;
    sum += ball.velocity.norm();
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

/// Sums of samples of a run.
struct Sums {
  double samples = 0;
  double temperature = 0;
  double pressure = 0;  // each over the time since the last sample; all are equally long
  double speed = 0;
  double moving = 0;
};

std::optional<double> average(Observable observable, const Sums& sums, double area,
                              double collisions, double span) {
  const double moving = sums.moving / sums.samples;
  const double temperature = sums.temperature / sums.samples;
  const double pressure = sums.pressure / sums.samples;
  const double rate = moving > 0 && span > 0 ? 2 * collisions / (moving * span) : 0;
  switch (observable) {
    case Observable::temperature:
      return temperature;
    case Observable::pressure:
      return pressure;
    case Observable::Z:
      if (!(moving * temperature > 0)) return std::nullopt;
      return pressure * area / (moving * temperature);
    case Observable::collision_rate:
      return rate;
    case Observable::mean_free_path:
      if (!(rate > 0)) return std::nullopt;
      return sums.speed / sums.samples / rate;
  }
  return std::nullopt;
}

}  // namespace

Averages averages_of(const std::vector<Observable>& observables, const Scenario& scenario,
                     const Way& way, const AccuracyCrew& crew,
                     const std::function<void(double part)>& told) {
  Runner runner(scenario, way, crew);
  FluidMeter meter(scenario.start);
  Sums sums;
  double begun = 0;
  double collisions = 0;
  for (std::size_t sample = kForgotten; sample <= kSamples; ++sample) {
    const double part = static_cast<double>(sample) / static_cast<double>(kSamples);
    runner.advance_to(sample == kSamples ? scenario.end : scenario.end * part);
    told(part);
    const Simulation& simulation = runner.simulation();
    if (sample == kForgotten) {
      begun = simulation.time();
      collisions = -static_cast<double>(simulation.measure().ball_ball);
      runner.record_impacts();
      meter.begin_at(begun);
      continue;
    }
    const std::vector<Ball> balls = simulation.state();
    const Fluid fluid = meter.measure(simulation.time(), balls, runner.take_impacts());
    ++sums.samples;
    sums.temperature += fluid.temperature.value_or(0);
    sums.pressure += fluid.pressure.value_or(0);
    sums.speed += mean_speed(balls);
    for (const Ball& ball : balls) sums.moving += ball.fixed ? 0 : 1;
  }
  collisions += static_cast<double>(runner.simulation().measure().ball_ball);
  const double area = scenario.start.box.width * scenario.start.box.height;
  Averages averages;
  for (const Observable each : observables) {
    averages.push_back(average(each, sums, area, collisions, runner.simulation().time() - begun));
  }
  return averages;
}

std::vector<std::optional<MeanAndError>> mean_over(const std::vector<Averages>& runs) {
  std::vector<std::optional<MeanAndError>> means;
  const auto count = static_cast<double>(runs.size());
  for (std::size_t i = 0; i < runs.front().size(); ++i) {
    double sum = 0;
    bool all = true;
    for (const Averages& run : runs) {
      all = all && run[i];
      sum += run[i].value_or(0);
    }
    if (!all) {
      means.emplace_back();
      continue;
    }
    MeanAndError mean{sum / count, {}};
    double squares = 0;
    for (const Averages& run : runs) squares += (*run[i] - mean.mean) * (*run[i] - mean.mean);
    if (runs.size() > 1) mean.standard_error = std::sqrt(squares / (count - 1) / count);
    means.emplace_back(mean);
  }
  return means;
}

}  // namespace carom::accuracy
