#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/forecast.hpp"
#include "accuracy/runner.hpp"
#include "accuracy/scenario.hpp"
#include "carom/accuracy.hpp"

namespace carom::accuracy {

/// A run that is planned.
struct Planned {
  Way way;
  AccuracyCrew crew;
  /// Where it is a row's run on another crew: the row.
  std::optional<std::size_t> same;
};

/// The runs of a study, in the order in which they are done: each method with its steps or digits
/// on the first crew, then one of each method on the others.
class StudyPlan {
 public:
  /// REQUIRES: a crew at least.
  StudyPlan(const Scenario& scenario, std::vector<AccuracyCrew> crews);

  [[nodiscard]] std::size_t size() const { return runs_.size(); }
  [[nodiscard]] const Planned& operator[](std::size_t at) const { return runs_[at]; }
  /// The runs that are planned, and those on other crews before it is known which.
  [[nodiscard]] std::size_t expected() const { return runs_.size() + unplanned_; }
  /// Seconds that the runs from number `next` on are foreseen to take; those that will be left out
  /// as too long count nothing.
  [[nodiscard]] double seconds(std::size_t next, const Forecast& forecast, double limit) const;

  /// Whether there is a run after number `at` with the same method and a shorter step.
  [[nodiscard]] bool goes_on_with_shorter_steps(std::size_t at) const;
  void leave_out_shorter_steps(std::size_t at);
  /// Adds the runs on the other crews: of each method that has a row, in steps that of the scene or
  /// the next shorter.
  void add_other_crews(const std::vector<AccuracyRow>& rows, double step);

 private:
  void add_steps(Method method);
  [[nodiscard]] bool is_shorter(const Planned& run, std::size_t at) const;

  std::vector<AccuracyCrew> crews_;
  std::vector<Planned> runs_;
  std::size_t unplanned_;  // runs on other crews, two each, until it is known which
};

}  // namespace carom::accuracy
