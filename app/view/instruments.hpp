#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "carom/fluid.hpp"
#include "carom/simulation.hpp"

namespace carom {

/// A mean over time; the error is the standard error of means over parts of that time.
struct TimeAverage {
  double mean = 0;
  std::optional<double> error;  ///< none where there are too few frames to tell
};

/// How many balls had which speed, relative to the mean velocity.
struct SpeedCounts {
  double top = 0;              ///< the speed at which the last class ends; faster ones are in it
  std::vector<double> counts;  ///< by classes of equal width from 0 on
  double total = 0;
  /// Of Maxwell's distribution for the measured temperature, in the same classes.
  std::vector<double> expected;
};

/// What equal hard disks would have in equilibrium.
struct FluidTheory {
  double Z = 0;
  double impacts_per_second = 0;
};

/// What the instruments have measured over the last `span` simulated seconds.
struct InstrumentReadings {
  double span = 0;
  SpeedCounts speeds;
  std::optional<TimeAverage> temperature;
  std::optional<TimeAverage> pressure;
  std::optional<TimeAverage> Z;
  std::optional<TimeAverage> impacts_per_second;  ///< between balls
  std::optional<double> mean_free_path;
  std::optional<FluidTheory> theory;
  // Frame by frame, the oldest first.
  std::vector<double> temperatures;
  std::vector<double> pressures;
  std::vector<double> compressibilities;  ///< Z
  std::vector<double> impact_rates;
  std::vector<double> kinetic;
  std::vector<double> potential;
  std::vector<double> dissipated;
  std::vector<double> error;  ///< relative
  double input = 0;           ///< by commands
};

/// Measures a simulation frame by frame, as the series of `run` does, and averages over the last
/// ten simulated seconds.
///
/// Threads: the control thread only.
class Instruments {
 public:
  static constexpr double kSpan = 10;

  [[nodiscard]] bool open() const { return meter_.has_value(); }
  void open(Simulation& simulation, const Measurements& measured);
  void close(Simulation& simulation);
  /// The simulation is another one, or has been changed: what was measured is forgotten.
  void begin_again(Simulation& simulation, const Measurements& measured);

  /// A frame was computed; `measured` is what the run has gone through.
  void measure(Simulation& simulation, const Measurements& measured);
  [[nodiscard]] InstrumentReadings readings() const;

 private:
  struct Sample {
    double time = 0;
    double span = 0;  ///< since the last one
    double temperature = 0;
    double pressure = 0;
    double mean_speed = 0;
    double kinetic = 0;
    double potential = 0;
    double dissipated = 0;
    double error = 0;
    double impacts_per_second = 0;
    std::vector<std::uint32_t> speeds;
  };

  void count_speeds(const std::vector<Ball>& balls, double temperature, Sample& sample);
  [[nodiscard]] SpeedCounts speeds() const;
  [[nodiscard]] std::optional<FluidTheory> theory(double temperature) const;
  [[nodiscard]] TimeAverage average(double Sample::*value) const;

  std::optional<FluidMeter> meter_;  // none: closed
  std::deque<Sample> samples_;
  double since_ = 0;  // simulated time of the last frame
  double top_ = 0;    // of the classes of speeds
  Box box_;
  Effects effects_;
  double input_ = 0;
  double counted_ = 0;  // impacts so far
  double moving_ = 0;
  bool equal_ = false;  // all balls move and are alike
  double radius_ = 0;
  double mass_ = 0;
  std::vector<std::pair<double, double>> masses_;  // of moving balls, with how many have each
};

/// Z of equal hard disks that fill this part of the plane, as a fluid.
/// Source: D. Henderson, Mol. Phys. 30 (1975) 971.
double henderson(double packing);

}  // namespace carom
