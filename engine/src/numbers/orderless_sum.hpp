#pragma once

#include <cmath>
#include <limits>

#include "numbers/scalar.hpp"

namespace carom::event {

/// Sums whose bits do not show the order of their terms: every term is first rounded to one grid,
/// on which all partial sums are exact.  Far quicker than rounding a sum once, and as right as
/// 2^-50 of the bound.
/// Source: Demmel, Nguyen, Fast reproducible floating-point summation, ARITH 2013.
template <class S>
class OrderlessSum {
 public:
  /// `bound`: not less than the sum of the terms' sizes.
  explicit OrderlessSum(const S& bound) : grid_(bound > 0 ? S(3 * power_above(bound)) : S(0)) {}

  /// The term as it counts.
  S rounded(const S& term) const { return (term + grid_) - grid_; }
  /// What does that, for many terms side by side.
  const S& grid() const { return grid_; }

 private:
  static S power_above(const S& bound) {
    using std::ilogb;
    using std::ldexp;
    return ldexp(S(1), static_cast<int>(ilogb(bound)) + 1);
  }

  S grid_;
};

}  // namespace carom::event
