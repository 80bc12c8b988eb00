#include "view/instruments.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace carom {
namespace {

constexpr std::size_t kClasses = 60;
constexpr double kTop = 4;       // thermal speeds of the lightest: 3e-4 of Maxwell's are faster
constexpr double kCooler = 0.6;  // the classes are chosen again where the temperature has changed
constexpr double kHotter = 1.6;
constexpr std::size_t kMost = 1200;       // frames: slow motion keeps no more
constexpr std::size_t kParts = 8;         // of the time, for errors
constexpr std::size_t kFewestFrames = 8;  // frames in a part
constexpr double kFreezing = 0.69;        // packing from which equal disks are no fluid

/// How much more often two disks touch than if they were spread evenly.
/// Source: D. Henderson, Mol. Phys. 30 (1975) 971.
double contact_value(double packing) {
  return (1 - 7 * packing / 16) / ((1 - packing) * (1 - packing));
}

}  // namespace

double henderson(double packing) {
  return 1 + 2 * packing * contact_value(packing);
}

void Instruments::open(Simulation& simulation, const Measurements& measured) {
  begin_again(simulation, measured);
}

void Instruments::close(Simulation& simulation) {
  meter_.reset();
  samples_.clear();
  simulation.record_impacts(false);
}

void Instruments::begin_again(Simulation& simulation, const Measurements& measured) {
  samples_.clear();
  top_ = 0;
  const Scene scene = simulation.save();
  box_ = scene.box;
  meter_.emplace(scene);
  since_ = simulation.time();
  meter_->begin_at(since_);
  simulation.record_impacts(true);
  (void)simulation.take_impacts();
  counted_ = static_cast<double>(measured.ball_ball);
  input_ = measured.energy_input;
}

void Instruments::measure(Simulation& simulation, const Measurements& measured) {
  if (!open()) return;
  const auto counted = static_cast<double>(measured.ball_ball);
  if (simulation.time() < since_ || counted < counted_ || measured.energy_input != input_)
    return begin_again(simulation, measured);
  effects_ = simulation.effects();
  const std::vector<Ball> balls = simulation.state();
  const Fluid fluid = meter_->measure(simulation.time(), balls, simulation.take_impacts());

  Sample sample;
  sample.time = simulation.time();
  sample.span = sample.time - std::exchange(since_, sample.time);
  if (!(sample.span > 0)) return;
  sample.temperature = fluid.temperature.value_or(0);
  sample.pressure = fluid.pressure.value_or(0);
  sample.kinetic = effects_.gravity || effects_.attraction ? fluid.kinetic : measured.energy_final;
  sample.potential = measured.energy_final - sample.kinetic;
  sample.dissipated = measured.energy_dissipated;
  sample.error = measured.relative_energy_error();
  sample.impacts_per_second = (counted - std::exchange(counted_, counted)) / sample.span;
  count_speeds(balls, sample.temperature, sample);
  samples_.push_back(std::move(sample));
  while (samples_.size() > kMost || samples_.front().time < samples_.back().time - kSpan)
    samples_.pop_front();
}

void Instruments::count_speeds(const std::vector<Ball>& balls, double temperature, Sample& sample) {
  Vec2 momentum{0, 0};
  double mass = 0;
  std::map<double, double> masses;
  moving_ = 0;
  equal_ = true;
  const Ball* first = nullptr;
  for (const Ball& ball : balls) {
    if (ball.fixed) {
      equal_ = false;
      continue;
    }
    momentum += ball.mass * ball.velocity;
    mass += ball.mass;
    ++masses[ball.mass];
    ++moving_;
    if (first == nullptr) first = &ball;
    equal_ = equal_ && ball.radius == first->radius && ball.mass == first->mass;
  }
  if (first == nullptr) return;
  radius_ = first->radius;
  mass_ = first->mass;
  masses_.assign(masses.begin(), masses.end());
  const double top = kTop * std::sqrt(temperature / masses_.front().first);
  if (!(top > 0)) return;
  if (!(top_ > kCooler * top && top_ < kHotter * top)) {
    top_ = top;
    for (Sample& each : samples_) each.speeds.clear();
  }
  sample.speeds.assign(kClasses, 0);
  const Vec2 mean = momentum / mass;
  double sum = 0;
  for (const Ball& ball : balls) {
    if (ball.fixed) continue;
    const double speed = (ball.velocity - mean).norm();
    sum += ball.velocity.norm();
    const auto place = static_cast<std::size_t>(
        std::min(speed / top_ * static_cast<double>(kClasses), static_cast<double>(kClasses - 1)));
    ++sample.speeds[place];
  }
  sample.mean_speed = sum / moving_;
}

/// Each frame stands for the time since the last one.
TimeAverage Instruments::average(double Sample::*value) const {
  double span = 0;
  double sum = 0;
  std::vector<double> parts(kParts);
  std::vector<double> spans(kParts);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sample& sample = samples_[i];
    const std::size_t part = i * kParts / samples_.size();
    span += sample.span;
    spans[part] += sample.span;
    sum += sample.*value * sample.span;
    parts[part] += sample.*value * sample.span;
  }
  TimeAverage result;
  if (!(span > 0)) return result;
  result.mean = sum / span;
  if (samples_.size() < kParts * kFewestFrames) return result;
  double squares = 0;
  for (std::size_t part = 0; part < kParts; ++part) {
    if (!(spans[part] > 0)) return result;
    const double off = parts[part] / spans[part] - result.mean;
    squares += off * off;
  }
  constexpr auto kCount = static_cast<double>(kParts);
  result.error = std::sqrt(squares / (kCount * (kCount - 1)));
  return result;
}

SpeedCounts Instruments::speeds() const {
  SpeedCounts result;
  double temperature = 0;
  double count = 0;
  for (const Sample& sample : samples_) {
    if (sample.speeds.empty()) continue;
    result.counts.resize(kClasses);
    for (std::size_t k = 0; k < kClasses; ++k) result.counts[k] += sample.speeds[k];
    temperature += sample.temperature;
    ++count;
  }
  if (!(count > 0)) return result;
  for (const double each : result.counts) result.total += each;
  temperature /= count;
  result.top = top_;
  result.expected.resize(kClasses);
  double all = 0;
  for (const auto& [mass, balls] : masses_) all += balls;
  for (const auto& [mass, balls] : masses_) {
    const double scale = mass / (2 * temperature);
    const auto slower = [&](std::size_t k) {
      const double speed = top_ * static_cast<double>(k) / static_cast<double>(kClasses);
      return k == kClasses ? 1 : -std::expm1(-scale * speed * speed);
    };
    for (std::size_t k = 0; k < kClasses; ++k)
      result.expected[k] += result.total * balls / all * (slower(k + 1) - slower(k));
  }
  return result;
}

std::optional<FluidTheory> Instruments::theory(double temperature) const {
  const bool only_collisions = has_collisions(effects_) && effects_.collisions->restitution == 1 &&
                               !effects_.gravity && !effects_.drag && !effects_.friction &&
                               !effects_.attraction;
  const double area = box_.width * box_.height;
  const double packing = moving_ * std::numbers::pi * radius_ * radius_ / area;
  if (!only_collisions || !equal_ || !box_.periodic[0] || !box_.periodic[1] ||
      !(packing < kFreezing) || !(temperature > 0))
    return std::nullopt;
  // Enskog: a ball has 2 n sigma chi sqrt(pi k T / m) impacts a second.
  const double rate = 2 * moving_ / area * (2 * radius_) * contact_value(packing) *
                      std::sqrt(std::numbers::pi * temperature / mass_);
  return FluidTheory{henderson(packing), moving_ * rate / 2};
}

InstrumentReadings Instruments::readings() const {
  InstrumentReadings result;
  if (samples_.empty()) return result;
  result.input = input_;
  result.speeds = speeds();
  const double density = moving_ / (box_.width * box_.height);
  for (const Sample& sample : samples_) {
    result.temperatures.push_back(sample.temperature);
    result.pressures.push_back(sample.pressure);
    const double ideal = density * sample.temperature;
    result.compressibilities.push_back(ideal > 0 ? sample.pressure / ideal : 0);
    result.impact_rates.push_back(sample.impacts_per_second);
    result.kinetic.push_back(sample.kinetic);
    result.potential.push_back(sample.potential);
    result.dissipated.push_back(sample.dissipated);
    result.error.push_back(sample.error);
  }
  for (const Sample& sample : samples_) result.span += sample.span;
  if (!(moving_ > 0)) return result;
  const TimeAverage temperature = average(&Sample::temperature);
  const TimeAverage pressure = average(&Sample::pressure);
  result.temperature = temperature;
  result.pressure = pressure;
  const double ideal = density * temperature.mean;
  if (ideal > 0) {
    result.Z = TimeAverage{pressure.mean / ideal, std::nullopt};
    if (pressure.error) result.Z->error = *pressure.error / ideal;
  }
  const TimeAverage impacts = average(&Sample::impacts_per_second);
  result.impacts_per_second = impacts;
  if (impacts.mean > 0)
    result.mean_free_path = average(&Sample::mean_speed).mean * moving_ / (2 * impacts.mean);
  result.theory = theory(temperature.mean);
  return result;
}

}  // namespace carom
