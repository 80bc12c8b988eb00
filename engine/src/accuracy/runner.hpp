#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/scenario.hpp"
#include "carom/accuracy.hpp"
#include "carom/simulation.hpp"

namespace carom::accuracy {

/// One way of computing a scene.
struct Way {
  Method method = Method::event;
  std::optional<double> step;  ///< absent: the scene has one that is not taken
  int digits = 16;
};

/// As in "overlap at 1/240 s".
std::string name_of(const Way& way);

/// A simulation that goes through a scenario.
///
/// Errors: what Simulation throws.
class Runner {
 public:
  Runner(const Scenario& scenario, const Way& way, const AccuracyCrew& crew = {});

  /// Moves on to `time`, obeying the commands on its way; not before the present time.
  void advance_to(double time);
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }
  /// Notes impacts from now on.
  void record_impacts() { simulation_.record_impacts(true); }
  /// Those since it was asked last.
  [[nodiscard]] std::vector<Impact> take_impacts() { return simulation_.take_impacts(); }

 private:
  const Scenario& scenario_;
  Simulation simulation_;
  std::size_t next_ = 0;  // command
};

}  // namespace carom::accuracy
