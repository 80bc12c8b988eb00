#pragma once

#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "contact/event_scalar.hpp"
#include "solvers/event/ticks.hpp"

namespace carom::event {

/// A binary number of so many decimal digits, rounded by MPFR; it lives where it is declared.
template <unsigned kDigits>
using Wide10 = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<kDigits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

// What is asked for, and what else fits into as many machine words: 2, 3 and 6 of 64 bits.
using Digits34 = Wide10<38>;
using Digits50 = Wide10<57>;
using Digits100 = Wide10<115>;

/// The clock of a wide run: its times are whole numbers of ticks, too, held in the wide number, in
/// which their differences are exact.
///
/// Holds: a tick is 2^8 units of rounding of the time it takes to cross the box.
template <class S>
class Clock {
 public:
  using Time = S;
  using At = const S&;
  static constexpr int kDigits = std::numeric_limits<S>::digits;
  static constexpr int kBits = kDigits - 8;

  static const Time& never() {
    static const Time kInfinite = std::numeric_limits<S>::infinity();
    return kInfinite;
  }
  static const Time& ever() {
    static const Time kLongAgo = -power(kDigits - 1);
    return kLongAgo;
  }
  static const Time& longest_flight() {
    static const Time kLongest = power(kDigits - 2);
    return kLongest;
  }
  static const Time& era() {
    static const Time kLength = power(kDigits - 3);
    return kLength;
  }

  Clock() : Clock(1) {}
  explicit Clock(double crossing)
      : tick_(power(std::ilogb(crossing) - kBits)),
        per_second_(power(kBits - std::ilogb(crossing))) {}

  /// REQUIRES: a power of two.
  static Clock of_tick(double tick) {
    Clock clock;
    clock.tick_ = tick;
    clock.per_second_ = 1 / clock.tick_;
    return clock;
  }

  [[nodiscard]] S seconds(const Time& ticks) const { return ticks * tick_; }
  [[nodiscard]] Time ticks(const S& seconds) const {
    const S exact = seconds * per_second_;
    return exact < longest_flight() ? whole(exact) : never();
  }
  static Time whole(const S& ticks) { return floor(ticks); }
  [[nodiscard]] const S& tick() const { return tick_; }
  [[nodiscard]] const S& per_second() const { return per_second_; }
  [[nodiscard]] const S& resolution() const { return tick_; }

  static std::int64_t steps(const Time& span, int shift) {
    constexpr std::int64_t kMost = std::int64_t{1} << 62;
    const S number = ldexp(span, -shift);
    return number < kMost ? number.template convert_to<std::int64_t>() : kMost;
  }
  static Time span(std::int64_t steps, int shift) { return ldexp(S(steps), shift); }
  static int shift_of(const Time& span) {
    int exponent = 0;
    frexp(span, &exponent);
    return exponent > 1 ? exponent - 1 : 0;
  }

 private:
  static S power(int exponent) { return ldexp(S(1), exponent); }

  S tick_;
  S per_second_;
};

}  // namespace carom::event
