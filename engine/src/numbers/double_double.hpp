#pragma once

#include "numbers/scalar.hpp"

namespace carom::event {

/// An unevaluated sum of two doubles, about 106 bits: enough to decide on which side of zero a
/// value lies that double arithmetic cannot tell from zero. Sums and products commute, and change
/// sign, to the last bit.
/// Source: Dekker 1971; bounds by Joldes, Muller, Popescu, ACM TOMS 44
/// (2017) 15.
struct DoubleDouble {
  double high;
  double low;

  explicit DoubleDouble(double a) : high(a), low(0) {}
  DoubleDouble(double a, double b) : high(a + b), low(b - (high - a)) {}

  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const auto highs = two_sum(a.high, b.high);
    const auto lows = two_sum(a.low, b.low);
    const DoubleDouble once(highs.high, highs.low + lows.high);
    return {once.high, once.low + lows.low};
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
    return a + DoubleDouble(-b.high, -b.low);
  }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const auto p = two_product(a.high, b.high);
    return {p.high, p.low + (a.high * b.low + a.low * b.high)};
  }
};

/// The number a doubtful sign is decided in: double-double for double; a wider scalar decides by
/// itself.
template <class S>
struct WideOf {
  using Type = S;
};
template <>
struct WideOf<double> {
  using Type = DoubleDouble;
};
template <class S>
using Wide = typename WideOf<S>::Type;

inline DoubleDouble widen(double a) {
  return DoubleDouble(a);
}
template <class S>
const S& widen(const S& a) {
  return a;
}

inline double narrow(const DoubleDouble& a) {
  return a.high;
}
template <class S>
S narrow(const S& a) {
  return a;
}

}  // namespace carom::event
