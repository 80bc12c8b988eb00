#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "accuracy/runner.hpp"
#include "accuracy/timing.hpp"

namespace carom::accuracy {

/// What one run that should come to rest has shown.
struct RestRun {
  std::size_t workers = 1;
  double seconds = 0;  ///< wall clock, of computing alone
  double cpu_seconds = 0;
  double equilibrium_residual = 0;  ///< at the end
  double creep = 0;                 ///< farthest move in the last third of the time, in radii
  double kinetic_energy = 0;        ///< at the end, of m g r summed over the balls that can move
  std::optional<double> rest_time;  ///< seconds; absent: it still moved at the end
  double dissipation_error = 0;     ///< the unexplained part of the energy book
  double max_overlap = 0;
  std::uint64_t ball_ball = 0;
  std::uint64_t ball_wall = 0;
  double height = 0;  ///< of the centre of mass at the end, against gravity
};

/// Kinetic energy below this part of m g r is rest.
inline constexpr double kAtRest = 1e-9;

/// `limit`: seconds that a run may take; far longer ones are given up.
/// `told`: often, with the part of the time that is simulated.
/// Errors: TooLong; what `told` and Simulation throw.
RestRun run_to_rest(const Scenario& scenario, const Way& way, const AccuracyCrew& crew,
                    double limit, const std::function<void(double part)>& told);

}  // namespace carom::accuracy
