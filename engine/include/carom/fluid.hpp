#pragma once

#include <optional>
#include <vector>

#include "carom/impact.hpp"
#include "carom/scene.hpp"

namespace carom {

/// What a moment says of the balls as a fluid.
struct Fluid {
  double kinetic = 0;                 ///< with the spins
  std::optional<double> temperature;  ///< k_B = 1; none without a moving ball
  std::optional<double> pressure;     ///< by the virial since the last frame; none at the first
  std::optional<double> Z;            ///< P A / (N k T)
};

/// Measures temperature and pressure, frame by frame.
///
/// The temperature is the kinetic energy relative to the centre of mass, by degree of freedom: of N
/// moving balls, or of N - 1 where an axis is periodic, as the centre of mass then keeps its
/// velocity.  The pressure is (N k T + sum r.J / (2 dt)) / A over the impacts of balls in dt.
/// Source: Allen, Tildesley, Computer Simulation of Liquids, 2nd ed., 2017, section 2.4; J. J.
/// Erpenbeck, W. W. Wood, in Statistical Mechanics B, 1977, for impulses.
class FluidMeter {
 public:
  explicit FluidMeter(const Scene& scene)
      : area_(scene.box.width * scene.box.height),
        periodic_(scene.box.periodic[0] || scene.box.periodic[1]),
        spins_(scene.effects.friction.has_value()) {}

  /// `impacts`: those since the last frame.
  Fluid measure(double time, const std::vector<Ball>& balls, const std::vector<Impact>& impacts);
  /// The next frame is measured from this one on.
  void begin_at(double time) { since_ = time; }

 private:
  double area_;
  bool periodic_;
  bool spins_;
  std::optional<double> since_;  // simulated time of the last frame
};

}  // namespace carom
