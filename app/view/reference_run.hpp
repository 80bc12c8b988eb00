#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "carom/session.hpp"

namespace carom {

/// A more exact run of the same scene, beside the one that is watched: it begins where that one
/// stands, and shows how far the two part.
///
/// It is computed by method event, on one worker; beside a run of that method with more digits, or
/// with shorter steps where the method takes some.
/// Threads: the control thread only.
/// Errors: the constructor throws SceneError where the method cannot take the scene.
class ReferenceRun {
 public:
  explicit ReferenceRun(const Session& session);

  /// Moves on to the moment that the run shows, which between two steps is the last one's end.
  /// REQUIRES: `is_of(run)`.
  void follow(const Simulation& run);
  /// False once a command has changed the balls or the energy of the run: it is another one then.
  [[nodiscard]] bool is_of(const Simulation& run) const;

  [[nodiscard]] Frame frame() const { return simulation_.frame(); }
  /// The largest distance of a ball between the two, as of the last `follow`.
  [[nodiscard]] double distance() const { return distance_; }
  /// The simulated time until the two were first apart by more than a hundredth of the smallest
  /// radius: the predictability horizon of the run.  None yet: `span` at the least.
  [[nodiscard]] std::optional<double> horizon() const { return horizon_; }
  /// The simulated time that the two have been compared.
  [[nodiscard]] double span() const { return span_; }
  [[nodiscard]] const std::string& name() const { return name_; }  ///< as in "event, 34 digits"

 private:
  Box box_;
  double begun_;  // the run's moment at the start of this one
  std::size_t balls_;
  double energy_input_;
  std::string name_;
  Simulation simulation_;
  double radius_;  // the smallest
  double distance_ = 0;
  double span_ = 0;
  std::optional<double> horizon_;
};

}  // namespace carom
