#pragma once

#include <limits>

#include "numbers/scalar.hpp"

namespace carom::event {

/// The part of v along r, (v.r / r.r) r: what a frictionless impact can change. r need not be a
/// unit vector and is never made one, so no rounding of a length enters the energy; in double one
/// step of refinement leaves little more than the rounding of the result, and along an axis the
/// result is v itself. The same bits, with their signs, for -r or -v, for mirrored x or y, and
/// for x and y swapped.
template <class S>
Vec<S> along(const Vec<S>& v, const Vec<S>& r) {
  const S rr = r.x * r.x + r.y * r.y;
  if constexpr (kIsDouble<S>) {
    const auto vx = two_product(v.x, r.x);
    const auto vy = two_product(v.y, r.y);
    const auto wanted = two_sum(vx.high, vy.high);
    const double wanted_low = wanted.low + (vx.low + vy.low);
    const double k = (wanted.high + wanted_low) / rr;
    const Vec<double> p{k * r.x, k * r.y};
    const auto px = two_product(p.x, r.x);
    const auto py = two_product(p.y, r.y);
    const auto got = two_sum(px.high, py.high);
    const double excess = (got.high - wanted.high) + ((got.low + (px.low + py.low)) - wanted_low);
    const double correction = excess / rr;
    return {std::fma(-correction, r.x, p.x), std::fma(-correction, r.y, p.y)};
  } else {
    const S k = (v.x * r.x + v.y * r.y) / rr;
    return {k * r.x, k * r.y};
  }
}

/// Velocities of the two after an impact.
template <class S>
struct Velocities {
  Vec<S> a;
  Vec<S> b;
};

/// A share of the impulse: factor * part taken from v in one rounding.
template <class S>
Vec<S> less(const Vec<S>& v, const S& factor, const Vec<S>& part) {
  return {multiply_add(S(-factor), part.x, v.x), multiply_add(S(-factor), part.y, v.y)};
}

/// The impact of two disks: J = -(1 + e) (v_b - v_a).n / (1/m_a + 1/m_b) along n, r = n |r| from
/// a to b. An inverse mass of 0 is a fixed ball; both 0, or balls that do not approach: nothing
/// happens.
///
/// Holds: afterwards they do not approach, in the very bits that pair_time() looks at: where
/// rounding leaves an approach (e = 0), or swallows an impulse (balls that graze, or that fly
/// together much faster than they approach), the least power of two of it that shows is added, so
/// that no impact happens twice. (b, a, -r) gives the same bits as (a, b, r); mirrors and swapped
/// axes give mirrored and swapped bits.
template <class S>
Velocities<S> pair_impact(const Vec<S>& r, const Vec<S>& v_a, const Vec<S>& v_b,
                          const S& inverse_mass_a, const S& inverse_mass_b, const S& restitution) {
  const S inverse_masses = inverse_mass_a + inverse_mass_b;
  const Vec<S> v = v_b - v_a;
  if (!(sharp_dot(r, v) < 0) || !(inverse_masses > 0)) {
    return {v_a, v_b};
  }
  const Vec<S> part = along(v, r);
  const S share_a = (1 + restitution) * (inverse_mass_a / inverse_masses);
  const S share_b = (1 + restitution) * (inverse_mass_b / inverse_masses);
  Velocities<S> result{less(v_a, S(-share_a), part), less(v_b, share_b, part)};
  S more = std::numeric_limits<S>::epsilon();
  while (sharp_dot(r, result.b - result.a) < 0) {
    const S times = 1 + more;
    result = {less(v_a, S(-share_a * times), part), less(v_b, S(share_b * times), part)};
    more = more * 2;
  }
  return result;
}

/// A wall turns the normal component round; the tangential one is not touched.
template <class S>
S wall_impact(const S& normal_velocity, const S& restitution) {
  return -restitution * normal_velocity;
}

}  // namespace carom::event
