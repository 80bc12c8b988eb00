#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

namespace carom::event {

/// Two components over any scalar: double, or a binary floating-point number of
/// Boost.Multiprecision (expression templates off).
template <class S>
struct Vec {
  S x;
  S y;

  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec operator-(const Vec& a) { return {-a.x, -a.y}; }
  friend Vec operator*(const S& k, const Vec& a) { return {k * a.x, k * a.y}; }
  friend bool operator==(const Vec& a, const Vec& b) { return a.x == b.x && a.y == b.y; }
};

template <class S>
inline constexpr bool kIsDouble = std::is_same_v<S, double>;

/// What a time is that never comes.
template <class S>
S never() {
  return std::numeric_limits<S>::infinity();
}

template <class S>
S absolute(const S& a) {
  if constexpr (kIsDouble<S>) {
    return std::abs(a);
  } else {
    return a < 0 ? S(-a) : a;
  }
}

template <class S>
S larger(const S& a, const S& b) {
  return a < b ? b : a;
}

template <class S>
S root(const S& a) {
  using std::sqrt;
  return sqrt(a);
}

/// The number itself, but 0 for -0: the sign of a zero shows in which order terms were added.
template <class S>
S with_plain_zero(const S& a) {
  return a + S(0);
}

/// a b + c rounded once in double; a wider scalar is rounded twice, far below what is asked of
/// it.
template <class S>
S multiply_add(const S& a, const S& b, const S& c) {
  if constexpr (kIsDouble<S>) {
    return std::fma(a, b, c);
  } else {
    return a * b + c;
  }
}

/// A sum and what its rounding lost: high + low is a + b exactly, the same bits for (b, a).
/// Source: Knuth, The Art of Computer Programming 2, 4.2.2, theorem B.
template <class S>
struct Split {
  S high;
  S low;
};

template <class S>
Split<S> two_sum(const S& a, const S& b) {
  const S sum = a + b;
  const S b_part = sum - a;
  const S a_part = sum - b_part;
  const S a_lost = a - a_part;
  const S b_lost = b - b_part;
  return {sum, a_lost + b_lost};
}

/// A product and what its rounding lost.
inline Split<double> two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// a b + c d to 2 u of itself however much of it cancels, with the same bits for (c, d, a, b).
/// Source: Cornea, Harrison, Tang 2002; bound by Jeannerod, ACM TOMS 42 (2016) 19. Kahan's
/// shorter form rounds its two products differently, so its bits change when x and y are swapped.
template <class S>
S sum_of_products(const S& a, const S& b, const S& c, const S& d) {
  if constexpr (kIsDouble<S>) {
    const double p = a * b;
    const double q = c * d;
    const double p_lost = std::fma(a, b, -p);
    const double q_lost = std::fma(c, d, -q);
    return (p + q) + (p_lost + q_lost);
  } else {
    return a * b + c * d;
  }
}

template <class S>
S dot(const Vec<S>& a, const Vec<S>& b) {
  return sum_of_products(a.x, b.x, a.y, b.y);
}

template <class S>
S cross(const Vec<S>& a, const Vec<S>& b) {
  return sum_of_products(a.x, b.y, S(-a.y), b.x);
}

/// r.r - s^2 to about u of itself down to gaps of 2^-52 s, the same bits when x and y are
/// swapped. The squares are kept with what their rounding lost (Ogita, Rump, Oishi, SIAM J. Sci.
/// Comput. 26 (2005) 1955).
template <class S>
S squared_gap(const Vec<S>& r, const S& s) {
  if constexpr (kIsDouble<S>) {
    const double xx = r.x * r.x;
    const double yy = r.y * r.y;
    const double ss = s * s;
    const double squares_lost = std::fma(r.x, r.x, -xx) + std::fma(r.y, r.y, -yy);
    const double s_lost = std::fma(s, s, -ss);
    const auto sum = two_sum(xx, yy);
    const auto difference = two_sum(sum.high, -ss);
    return difference.high + ((difference.low + sum.low) + (squares_lost - s_lost));
  } else {
    return r.x * r.x + r.y * r.y - s * s;
  }
}

/// a.b to u of itself and u^2 of |a||b|: one rounding better than dot() where little cancels.
template <class S>
[[gnu::always_inline]] inline S sharp_dot(const Vec<S>& a, const Vec<S>& b) {
  if constexpr (kIsDouble<S>) {
    const double p = a.x * b.x;
    const double q = a.y * b.y;
    const double lost = std::fma(a.x, b.x, -p) + std::fma(a.y, b.y, -q);
    const auto sum = two_sum(p, q);
    return sum.high + (sum.low + lost);
  } else {
    return a.x * b.x + a.y * b.y;
  }
}

}  // namespace carom::event
