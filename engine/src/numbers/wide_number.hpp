#pragma once

#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace carom {

/// A binary floating-point number of as many digits as the run asks for, rounded to nearest by
/// MPFR; its digits lie in the number itself, so that arithmetic allocates nothing.
///
/// REQUIRES: a WidePrecision in scope of the thread wherever a number comes from anything but a
/// copy.
/// Holds: results have the precision in scope.
/// Threads: the precision is each thread's own; numbers are plain values.
class WideNumber {
 public:
  static constexpr int kMostBits = 384;

  WideNumber() { start(MPFR_ZERO_KIND); }
  WideNumber(double value) : WideNumber() {  // NOLINT(google-explicit-constructor): a number
    mpfr_set_d(it(), value, MPFR_RNDN);
  }
  template <std::integral Whole>
  WideNumber(Whole value) : WideNumber() {  // NOLINT(google-explicit-constructor)
    mpfr_set_si(it(), static_cast<long>(value), MPFR_RNDN);
  }
  /// REQUIRES: a decimal number.
  explicit WideNumber(const std::string& text) : WideNumber() {
    mpfr_set_str(it(), text.c_str(), 10, MPFR_RNDN);
  }
  WideNumber(const WideNumber& other) : limbs_(other.limbs_) { take(other); }
  WideNumber& operator=(const WideNumber& other) {
    limbs_ = other.limbs_;
    take(other);
    return *this;
  }
  ~WideNumber() = default;

  static WideNumber infinity() {
    WideNumber result;
    result.start(MPFR_INF_KIND);
    return result;
  }
  /// The bits of the precision in scope.
  static int bits() { return bits_; }
  /// Decimal digits that are read back to the same bits.
  [[nodiscard]] std::string text() const;

  explicit operator double() const { return mpfr_get_d(it(), MPFR_RNDN); }
  explicit operator std::int64_t() const { return mpfr_get_si(it(), MPFR_RNDZ); }

  friend WideNumber operator-(const WideNumber& a) { return of(mpfr_neg, a); }
  friend WideNumber operator+(const WideNumber& a, const WideNumber& b) {
    return of(mpfr_add, a, b);
  }
  friend WideNumber operator-(const WideNumber& a, const WideNumber& b) {
    return of(mpfr_sub, a, b);
  }
  friend WideNumber operator*(const WideNumber& a, const WideNumber& b) {
    return of(mpfr_mul, a, b);
  }
  friend WideNumber operator/(const WideNumber& a, const WideNumber& b) {
    return of(mpfr_div, a, b);
  }
  WideNumber& operator+=(const WideNumber& b) { return *this = *this + b; }
  WideNumber& operator-=(const WideNumber& b) { return *this = *this - b; }
  WideNumber& operator*=(const WideNumber& b) { return *this = *this * b; }
  WideNumber& operator/=(const WideNumber& b) { return *this = *this / b; }

  friend bool operator==(const WideNumber& a, const WideNumber& b) {
    return mpfr_equal_p(a.it(), b.it()) != 0;
  }
  friend bool operator<(const WideNumber& a, const WideNumber& b) {
    return mpfr_less_p(a.it(), b.it()) != 0;
  }
  friend bool operator>(const WideNumber& a, const WideNumber& b) { return b < a; }
  friend bool operator<=(const WideNumber& a, const WideNumber& b) {
    return mpfr_lessequal_p(a.it(), b.it()) != 0;
  }
  friend bool operator>=(const WideNumber& a, const WideNumber& b) { return b <= a; }

  friend WideNumber sqrt(const WideNumber& a) { return of(mpfr_sqrt, a); }
  friend WideNumber exp(const WideNumber& a) { return of(mpfr_exp, a); }
  friend WideNumber log1p(const WideNumber& a) { return of(mpfr_log1p, a); }
  friend WideNumber abs(const WideNumber& a) { return of(mpfr_abs, a); }
  friend WideNumber floor(const WideNumber& a) { return of(mpfr_rint_floor, a); }
  friend WideNumber rint(const WideNumber& a) { return of(mpfr_rint, a); }
  friend WideNumber ldexp(const WideNumber& a, int exponent) {
    WideNumber result;
    mpfr_mul_2si(result.it(), a.it(), exponent, MPFR_RNDN);
    return result;
  }
  /// The exponent e of |a| = m 2^e, 1 <= m < 2.
  /// REQUIRES: not zero, finite.
  friend int ilogb(const WideNumber& a) { return static_cast<int>(mpfr_get_exp(a.it())) - 1; }

 private:
  friend class WidePrecision;
  static constexpr std::size_t kLimbs = kMostBits / (8 * sizeof(mp_limb_t));

  mpfr_ptr it() { return &value_; }
  [[nodiscard]] mpfr_srcptr it() const { return &value_; }
  void start(int kind) { mpfr_custom_init_set(it(), kind, 0, bits_, limbs_.data()); }
  void take(const WideNumber& other) {
    value_ = other.value_;
    mpfr_custom_move(it(), limbs_.data());
  }
  template <class Function>
  static WideNumber of(const Function& function, const WideNumber& a) {
    WideNumber result;
    function(result.it(), a.it(), MPFR_RNDN);
    return result;
  }
  template <class Function>
  static WideNumber of(const Function& function, const WideNumber& a, const WideNumber& b) {
    WideNumber result;
    function(result.it(), a.it(), b.it(), MPFR_RNDN);
    return result;
  }

  static inline thread_local int bits_ = 128;  // NOLINT(readability-identifier-naming)

  __mpfr_struct value_;
  std::array<mp_limb_t, kLimbs> limbs_{};
};

/// For as long as it lives, numbers of its thread get so many decimal digits, and a little more:
/// whole machine words.
class WidePrecision {
 public:
  /// REQUIRES: 34, 50 or 100.
  explicit WidePrecision(int digits) : before_(WideNumber::bits_) {
    free_caches_with_thread();
    WideNumber::bits_ = digits <= 34 ? 128 : (digits <= 50 ? 191 : WideNumber::kMostBits);
  }
  ~WidePrecision() { WideNumber::bits_ = before_; }
  WidePrecision(const WidePrecision&) = delete;
  WidePrecision& operator=(const WidePrecision&) = delete;

 private:
  /// MPFR keeps constants and memory for each thread; they go when the thread ends.
  static void free_caches_with_thread();

  int before_;
};

}  // namespace carom

namespace std {

/// Of the precision in scope.
template <>
class numeric_limits<carom::WideNumber> {
 public:
  // NOLINTBEGIN(readability-identifier-naming): the names of the standard
  static constexpr bool is_specialized = true;
  static constexpr bool is_signed = true;
  static constexpr bool has_infinity = true;
  // NOLINTEND(readability-identifier-naming)
  static carom::WideNumber infinity() { return carom::WideNumber::infinity(); }
  static carom::WideNumber epsilon() {
    return ldexp(carom::WideNumber(1), 1 - carom::WideNumber::bits());
  }
};

}  // namespace std
