#pragma once

#include <cmath>

#include "carom/vector.hpp"

namespace carom {

/// The line through the centres of two balls.
/// Holds: `r` points from the first ball to the second; it need not be normalised, nor be as long
/// as the centres are apart.
struct LineOfCentres {
  Vec2 r{1, 0};
  double square = 1;    ///< r.r
  double length = 1;    ///< |r|
  double distance = 1;  ///< of the centres
};

/// The line of centres of balls that are `r` apart and move with `velocity` relative to each other.
/// Where the centres coincide it lies along the relative motion, so that they approach, else along
/// x.
inline LineOfCentres line_of_centres(const Vec2& r, const Vec2& velocity) {
  // Squares of tiny numbers lose their digits; a power of two restores them without rounding.
  constexpr double kTiny = 0x1p-480;
  constexpr double kScale = 0x1p+500;
  const bool coincide = r.x() == 0 && r.y() == 0;
  const bool still = velocity.x() == 0 && velocity.y() == 0;
  Vec2 along = coincide ? (still ? Vec2(1, 0) : Vec2(-velocity)) : r;
  const double size = std::fmax(std::abs(along.x()), std::abs(along.y()));
  const double scale = size < kTiny ? kScale : 1;
  along *= scale;
  const double square = along.x() * along.x() + along.y() * along.y();
  const double length = std::sqrt(square);
  return {along, square, length, coincide ? 0 : length / scale};
}

/// The impulse of an impact along a line of centres, in units of its `r`: J r / m is the change of
/// velocity.  `closing` is v.r, negative; the unnormalised line keeps rounding from favouring
/// either side of the energy balance.
inline double impulse(double closing, double square, double inverse_masses, double restitution) {
  return -(1 + restitution) * closing / (square * inverse_masses);
}

/// Whether balls of velocities `v` and `w` approach along a line: `closing` is the relative
/// velocity times `r`, `length` is |r|.  An approach so slow that rounding of the velocities makes
/// it does not count.
inline bool approaches(double closing, double length, const Vec2& v, const Vec2& w) {
  constexpr double kRounding = 0x1p-47;
  const double speeds = std::abs(v.x()) + std::abs(v.y()) + std::abs(w.x()) + std::abs(w.y());
  return -closing > kRounding * length * speeds;
}

}  // namespace carom
