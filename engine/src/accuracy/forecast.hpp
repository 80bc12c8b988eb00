#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "accuracy/runner.hpp"
#include "accuracy/scenario.hpp"
#include "carom/accuracy.hpp"

namespace carom::accuracy {

/// How long the runs to come will take, wall-clock seconds.
///
/// At first from short pilot runs, then from what has been measured: a run in steps costs a part
/// that all steps have in common and a part for each step.
class Forecast {
 public:
  /// `limit`: of one run.
  /// Errors: none; what cannot be run is foreseen to take no time.
  Forecast(const Scenario& scenario, double limit);

  /// Both precisions of the reference had taken this long.
  void learn_reference(double seconds, int digits) { reference_ = {{seconds, digits}}; }
  void learn(const AccuracyRow& row);

  /// The reference, before anything is known of it.
  [[nodiscard]] double reference() const;
  /// One run.
  [[nodiscard]] double run(const Way& way) const;
  /// What becomes a row: the run that is compared, and those that are timed.
  [[nodiscard]] double row(const Way& way) const { return with_repeats(run(way)); }
  [[nodiscard]] double with_repeats(double run) const;

 private:
  /// Steps of a method by their length, longest first, with the seconds of a run.
  using Steps = std::map<double, double, std::greater<>>;

  [[nodiscard]] static double extrapolated(const Steps& steps, double step);

  double limit_;
  double exact_ = 0;  // event with 16 digits
  std::optional<std::pair<double, int>> reference_;
  std::map<int, double> digits_;
  std::map<Method, Steps> steps_;
};

}  // namespace carom::accuracy
