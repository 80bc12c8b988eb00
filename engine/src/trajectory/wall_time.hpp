#pragma once

#include "numbers/scalar.hpp"

namespace carom::event {

/// When a ball reaches a wall. All three are components along the wall's normal that points to
/// the ball's side: h the ball's distance from touching the wall, v its velocity and a its
/// acceleration. The upper wall of an axis at w sees h = w - radius - x, -v and -a: mirrored to
/// the last bit.
///
/// Holds: touching (h = 0, as every wall impact leaves it) or beyond and approaching is now;
/// leaving is not: then the next return is found, however short the bounce. A ball beyond the wall
/// that does not come out before it turns is hit when it turns. Pressed without moving (v = 0, a
/// < 0, h <= 0) is now: the case of rest_rules.hpp. A tangent touch from above is no impact.
/// Error: 4 u of the time, but for a near tangent (a > 0), as the quadratic amplifies.
template <class S>
S wall_time(const S& h, const S& v) {
  if (!(v < 0)) {
    return never<S>();
  }
  return h > 0 ? S(h / -v) : S(0);
}

template <class S>
S wall_time(const S& h, const S& v, const S& a) {
  if (a == 0) {
    return wall_time(h, v);
  }
  const S discriminant = sum_of_products(v, v, S(-2 * a), h);
  if (h > 0) {
    if (v < 0) {
      return discriminant > 0 ? S(2 * h / (root(discriminant) - v)) : never<S>();
    }
    return a < 0 ? S((v + root(discriminant)) / -a) : never<S>();
  }
  if (v < 0 || (v == 0 && a < 0)) {
    return S(0);
  }
  if (a > 0) {
    return never<S>();
  }
  return discriminant > 0 ? S((v + root(discriminant)) / -a) : S(v / -a);
}

/// The normal velocity with which it arrives, by the energy of the fall rather than by its time:
/// a ball that leaves the wall with v comes back with -v to the last bit, so bouncing for ever
/// costs no digits. Only for an impact that wall_time() found.
template <class S>
S wall_arrival_velocity(const S& h, const S& v, const S& a) {
  if (a == 0) {
    return v;
  }
  if (!(h > 0) && v < 0) {
    return v;
  }
  const S discriminant = sum_of_products(v, v, S(-2 * a), h);
  return discriminant > 0 ? S(-root(discriminant)) : S(0);
}

}  // namespace carom::event
