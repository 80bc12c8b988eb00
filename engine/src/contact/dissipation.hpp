#pragma once

namespace carom {

/// The energy that restitution takes at a contact: it is approached at one speed and left at the
/// other.  `inverse_masses`: of the two together, a wall has none.
inline double lost_to_restitution(double approach, double departure, double inverse_masses) {
  return (approach - departure) * (approach + departure) / (2 * inverse_masses);
}

/// What friction did at a contact: its impulse along t, and the energy that it took.
struct Rubbed {
  double impulse = 0;
  double lost = 0;
};

/// The energy that friction takes there, from uniform disks that slip at this speed, by its impulse
/// along t: the impulse times the mean of the slip before and after it.
inline double lost_to_friction(double slip, double impulse, double inverse_masses) {
  return -impulse * (slip + 1.5 * impulse * inverse_masses);
}

}  // namespace carom
