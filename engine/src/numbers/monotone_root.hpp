#pragma once

#include <limits>

#include "numbers/scalar.hpp"

namespace carom::event {

/// A function's value and slope at one place.
template <class S>
struct Tangent {
  S value;
  S slope;
};

/// The one root of a function that is monotone over [low, high] and has opposite signs at its
/// ends: Newton's steps, halving where they leave the bracket or do not halve it; it ends when a
/// step is at most `tolerance` of the root, when nothing lies between the ends, or only u^3 of what
/// initially lay between them. Only values and slopes are used, so the result scales exactly with
/// powers of two.
template <class S, class Function>
S monotone_root(const Function& tangent_at, S low, S high, bool rising, const S& tolerance,
                S start) {
  S t = start;
  if (!(low < t && t < high)) {
    t = low + (high - low) / 2;
  }
  S last_step = high - low;
  const S u = std::numeric_limits<S>::epsilon();
  const S least = last_step * u * u * u;
  for (;;) {
    const Tangent<S> f = tangent_at(t);
    if (f.value == 0) {
      return t;
    }
    if ((f.value < 0) == rising) {
      low = t;
    } else {
      high = t;
    }
    // A root at an end that is 0 would be halved for as long as numbers can become smaller.
    if (!(high - low > least)) {
      return t;
    }
    const S newton_step = -f.value / f.slope;
    S next = t + newton_step;
    const bool inside = low < next && next < high;
    if (absolute(newton_step) <= tolerance * absolute(t)) {
      return inside ? next : t;
    }
    if (!inside || absolute(newton_step) * 2 > absolute(last_step)) {
      next = low + (high - low) / 2;
      if (!(low < next && next < high)) {
        return t;
      }
    }
    last_step = next - t;
    t = next;
  }
}

}  // namespace carom::event
