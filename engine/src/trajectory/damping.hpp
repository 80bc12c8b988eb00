#pragma once

#include <cmath>

#include "numbers/scalar.hpp"

namespace carom::event {

/// What drag makes of a flight that has lasted x / rate: of its velocity, its way and its fall.
///
/// Holds: remaining = exp(-x), way = (1 - remaining) / x and fall = (1 - way) / x, at x = 0 their
/// limits 1, 1 and 1/2: nothing is divided by the rate, so a rate of 0 is no special case.
template <class S>
struct Damping {
  S remaining;
  S way;
  S fall;
};

/// Below this the series of `fall` is summed, in so many terms in double.
inline constexpr double kDampingSeries = 0.5;
inline constexpr int kDampingTerms = 15;
/// From here on nothing remains, in double: products with less than exp(-512) = 2^-738 would lose
/// digits at the lower end of its range, in one scale of lengths and not in another.
inline constexpr double kDampingEnd = 512;

/// 1 / (n + 2)!, the coefficients of `fall` in -x.
struct DampingCoefficients {
  double of[kDampingTerms] = {};

  constexpr DampingCoefficients() {
    double factorial = 2;
    for (int n = 0; n < kDampingTerms; ++n) {
      of[n] = 1 / factorial;
      factorial *= n + 3;
    }
  }
};
inline constexpr DampingCoefficients kDampingCoefficients;

// Always inlined, so that how vectors would be passed on does not matter.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

/// The series of `fall`, for a double or several side by side, with the same bits; `all` makes one
/// of a double, `fused` is a b + c rounded once.  Its terms are paired (Estrin's scheme), so that
/// one need not wait for the other.
template <class Real, class All, class Fused>
[[gnu::always_inline]] inline Real damping_series(const Real& x, const All& all,
                                                  const Fused& fused) {
  static_assert(kDampingTerms == 15);
  const auto c = [&all](int n) __attribute__((always_inline)) {
    return all(kDampingCoefficients.of[n]);
  };
  const Real y = -x;
  const Real y2 = y * y;
  const Real y4 = y2 * y2;
  const auto four = [&](int n) __attribute__((always_inline)) {
    return fused(y2, fused(y, c(n + 3), c(n + 2)), fused(y, c(n + 1), c(n)));
  };
  const Real last = fused(y2, c(14), fused(y, c(13), c(12)));
  return fused(Real(y4 * y4), fused(y4, last, four(8)), fused(y4, four(4), four(0)));
}

#pragma GCC diagnostic pop

/// Error: about 4 u of each of the three.
/// REQUIRES: x >= 0.
template <class S>
Damping<S> damping(const S& x) {
  using std::exp;
  if (!(x < kDampingSeries)) {
    const bool stopped = kIsDouble<S> && !(x < kDampingEnd);
    const S remaining = stopped ? S(0) : S(exp(S(-x)));
    const S way = (1 - remaining) / x;
    return {remaining, way, (1 - way) / x};
  }
  S fall = 0;
  if constexpr (kIsDouble<S>) {
    fall = damping_series(
        x, [](double a) { return a; },
        [](double a, double b, double c) { return std::fma(a, b, c); });
  } else {
    S term = S(1) / 2;
    for (int n = 3; absolute(term) > std::numeric_limits<S>::epsilon() / 4; ++n) {
      fall += term;
      term = -term * x / n;
    }
  }
  const S way = multiply_add(S(-x), fall, S(1));
  return {multiply_add(S(-x), way, S(1)), way, fall};
}

/// log(1 + y) / y, 1 at y = 0.
template <class S>
S log_1p_over(const S& y) {
  using std::log1p;
  return y == 0 ? S(1) : S(log1p(y) / y);
}

/// In s = (1 - exp(-rate t)) / rate flights under drag are straight relative to each other; this
/// gives the t that belongs to an s >= 0: never for rate s >= 1.
template <class S>
S time_of_way(const S& s, const S& rate) {
  if (!(s < never<S>())) return s;
  const S y = rate * s;
  return y < 1 ? S(s * log_1p_over(S(-y))) : never<S>();
}

}  // namespace carom::event
