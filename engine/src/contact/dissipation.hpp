#pragma once

#include <cmath>

namespace carom {

/// The energy that restitution takes at a contact: it is approached at one speed and left at the
/// other.  `inverse_masses`: of the two together, a wall has none.
inline double lost_to_restitution(double approach, double departure, double inverse_masses) {
  return (approach - departure) * (approach + departure) / (2 * inverse_masses);
}

/// What friction did at a contact: its impulse along t, and the energy that it took.
struct FrictionChange {
  double impulse = 0;
  double lost = 0;
};

/// The energy that friction takes there, from uniform disks that slip at this speed, by its impulse
/// along t: the impulse times the mean of the slip before and after it.
inline double lost_to_friction(double slip, double impulse, double inverse_masses) {
  return -impulse * (slip + 1.5 * impulse * inverse_masses);
}

/// The energy that an impulse takes that changes the velocity it acts against, along itself, from
/// `before` to `after`: its work, the impulse times their mean.
inline double lost_to_impulse(double impulse, double before, double after) {
  return -impulse * (before + after) / 2;
}

/// What drag takes from a flight along one axis, in parts of its mass:
/// rate * integral of v^2, with dv/dt = acceleration - rate v.
///
/// Holds: exact to rounding of v^2 and (a t)^2 for any rate and time, small ones too.
struct DragLoss {
  double of_square = 0;   ///< times v^2 at the start
  double of_product = 0;  ///< times v a
  double of_pull = 0;     ///< times a^2

  DragLoss() = default;
  DragLoss(double rate, double seconds) {
    const double z = rate * seconds;
    const double reach = z != 0 ? -std::expm1(-z) / rate : seconds;
    of_square = -std::expm1(-2 * z) / 2;
    of_product = rate * (reach * reach);
    // t^2 (z - 1 + exp(-z)) / z^2 - reach^2 / 2, whose leading parts cancel: z t^2 / 3 - ...
    const double square = seconds * seconds;
    if (std::abs(z) < kSmall) {
      of_pull = square * z * (1.0 / 3 - z * (0.25 - z * (7.0 / 60 - z / 24)));
    } else {
      of_pull = square * ((z + std::expm1(-z)) / (z * z)) - reach * reach / 2;
    }
  }

  [[nodiscard]] double along(double velocity, double acceleration) const {
    return of_square * (velocity * velocity) +
           acceleration * (of_product * velocity + of_pull * acceleration);
  }

 private:
  static constexpr double kSmall = 1e-4;
};

}  // namespace carom
