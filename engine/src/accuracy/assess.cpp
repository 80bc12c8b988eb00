#include "accuracy/assess.hpp"

#include <cmath>

namespace carom::accuracy {
namespace {

Way way_of(const AccuracyRow& row) {
  return {row.method, row.step, row.digits};
}

/// The step at whose ends alone a run can be looked at; event shows any moment.
std::optional<double> pace_of(const AccuracyRow& row) {
  return row.method == Method::overlap ? row.step : std::nullopt;
}

}  // namespace

std::optional<Loss> assess(AccuracyRow& row, const Scenario& scenario, const Samples& samples,
                           const Truth& truth, double smallest_radius, const Stopped& stopped) {
  const Box& box = scenario.start.box;
  Runner runner(scenario, way_of(row));
  std::optional<Loss> loss;
  std::size_t before = 0;  // the last sample at which it was compared
  const auto compare = [&](std::size_t sample) {
    const double apart =
        largest_distance(runner.simulation().exact_positions(), truth.at_sample[sample - 1], box);
    if (!std::isfinite(apart)) {
      throw std::runtime_error("the position of a ball is not a number");
    }
    if (!loss && apart > kLost * smallest_radius) {
      loss = Loss{before, sample};
      row.horizon = samples.time(sample);
      row.horizon_resolution = samples.time(sample) - samples.time(before);
    }
    before = sample;
    return apart;
  };
  for (std::size_t sample = 1; sample < truth.known() && !loss; ++sample) {
    if (!samples.compares(sample, pace_of(row))) continue;
    if (stopped && stopped()) throw StopAsked();
    runner.advance_to(samples.time(sample));
    (void)compare(sample);
  }
  if (truth.known() > 0 && (!loss || !truth.reference.holds_until)) {
    runner.advance_to(samples.time(truth.known()));
    const double apart = compare(truth.known());
    if (!truth.reference.holds_until) row.position_error = apart;
  }
  runner.advance_to(scenario.end);
  const Measurements measured = runner.simulation().measure();
  row.energy_error = measured.relative_energy_error();
  row.max_overlap = measured.max_overlap;
  row.ball_ball = measured.ball_ball;
  row.ball_wall = measured.ball_wall;
  return loss;
}

std::vector<std::uint64_t> fine_numbers(const AccuracyRow& row, const Loss& loss,
                                        const Samples& samples) {
  const std::uint64_t stride = samples.stride(pace_of(row));
  const double end = samples.time(loss.seen);
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t fine = (loss.before * Samples::kParts / stride + 1) * stride;
       samples.fine_time(fine) < end; fine += stride) {
    numbers.push_back(fine);
  }
  return numbers;
}

void refine_horizon(AccuracyRow& row, const Loss& loss, const Scenario& scenario,
                    const Samples& samples, const Truth& truth, double smallest_radius,
                    const Stopped& stopped) {
  Runner runner(scenario, way_of(row));
  double before = samples.time(loss.before);
  const auto seen = [&](double time) {
    row.horizon = time;
    row.horizon_resolution = time - before;
  };
  for (const std::uint64_t fine : fine_numbers(row, loss, samples)) {
    if (stopped && stopped()) throw StopAsked();
    const double time = samples.fine_time(fine);
    runner.advance_to(time);
    const double apart = largest_distance(runner.simulation().exact_positions(),
                                          truth.at_fine.at(fine), scenario.start.box);
    if (apart > kLost * smallest_radius) return seen(time);
    before = time;
  }
  seen(*row.horizon);
}

}  // namespace carom::accuracy
