#pragma once

#include <mpfr.h>

#include <array>
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
///
/// Each operation is a call: inlined, they made sources that use it several times as long to
/// compile, and the numbers no faster.
class WideNumber {
 public:
  static constexpr int kMostBits = 384;

  WideNumber();
  WideNumber(double value);  // NOLINT(google-explicit-constructor): a number
  template <std::integral Whole>
  WideNumber(Whole value)  // NOLINT(google-explicit-constructor)
      : WideNumber(Integer{static_cast<long>(value)}) {}
  /// REQUIRES: a decimal number.
  explicit WideNumber(const std::string& text);
  WideNumber(const WideNumber& other);
  WideNumber& operator=(const WideNumber& other);
  ~WideNumber() = default;

  static WideNumber infinity();
  /// The bits of the precision in scope.
  static int bits() { return bits_; }
  /// Decimal digits that are read back to the same bits.
  [[nodiscard]] std::string text() const;

  explicit operator double() const;
  explicit operator std::int64_t() const;

  friend WideNumber operator-(const WideNumber& a);
  friend WideNumber operator+(const WideNumber& a, const WideNumber& b);
  friend WideNumber operator-(const WideNumber& a, const WideNumber& b);
  friend WideNumber operator*(const WideNumber& a, const WideNumber& b);
  friend WideNumber operator/(const WideNumber& a, const WideNumber& b);
  WideNumber& operator+=(const WideNumber& b) { return *this = *this + b; }
  WideNumber& operator-=(const WideNumber& b) { return *this = *this - b; }
  WideNumber& operator*=(const WideNumber& b) { return *this = *this * b; }
  WideNumber& operator/=(const WideNumber& b) { return *this = *this / b; }

  friend bool operator==(const WideNumber& a, const WideNumber& b);
  friend bool operator<(const WideNumber& a, const WideNumber& b);
  friend bool operator>(const WideNumber& a, const WideNumber& b) { return b < a; }
  friend bool operator<=(const WideNumber& a, const WideNumber& b);
  friend bool operator>=(const WideNumber& a, const WideNumber& b) { return b <= a; }

  friend WideNumber sqrt(const WideNumber& a);
  friend WideNumber exp(const WideNumber& a);
  friend WideNumber log1p(const WideNumber& a);
  friend WideNumber abs(const WideNumber& a);
  friend WideNumber floor(const WideNumber& a);
  friend WideNumber rint(const WideNumber& a);
  friend WideNumber ldexp(const WideNumber& a, int exponent);
  /// The exponent e of |a| = m 2^e, 1 <= m < 2.
  /// REQUIRES: not zero, finite.
  friend int ilogb(const WideNumber& a);

 private:
  friend class WidePrecision;
  struct Integer {
    long value;
  };
  static constexpr std::size_t kLimbs = kMostBits / (8 * sizeof(mp_limb_t));

  explicit WideNumber(Integer whole);

  mpfr_ptr it() { return &value_; }
  [[nodiscard]] mpfr_srcptr it() const { return &value_; }
  void start(int kind);
  void take(const WideNumber& other);
  template <class Function>
  static WideNumber of(const Function& function, const WideNumber& a);
  template <class Function>
  static WideNumber of(const Function& function, const WideNumber& a, const WideNumber& b);

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
