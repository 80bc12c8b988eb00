#pragma once

#include <cmath>

namespace carom::effects {

/// Speeds up to this one come to rest where they meet an obstacle: what two steps of the
/// acceleration make.  A bounce that slow is over within two steps and cannot be told from rest.
/// Where nothing is lost in an impact nothing comes to rest.
inline double rest_speed(double acceleration, double step, double restitution) {
  return restitution < 1 ? 2 * std::abs(acceleration) * step : 0;
}

}  // namespace carom::effects
