#pragma once

#include <optional>
#include <vector>

#include "carom/scene.hpp"

namespace carom::accuracy {

/// What every run of a study goes through: a start, commands on the way, an end.
///
/// Units: simulated seconds from the start.
struct Scenario {
  struct Due {
    double at = 0;
    Command command;
  };

  Scene start;                ///< its balls; without fills, script and a past
  std::vector<Due> commands;  ///< in order of time; neither of the frame clock nor of the step
  double end = 0;
};

/// Errors: SceneError where a fill finds no room.
Scenario scenario_of(const Scene& scene, std::optional<double> time);

/// The starts of a scene from its seed on: so many where its fills are drawn from the seed, else
/// one.
std::vector<Scenario> starts_of(const Scene& scene, std::size_t seeds, std::optional<double> time);

}  // namespace carom::accuracy
