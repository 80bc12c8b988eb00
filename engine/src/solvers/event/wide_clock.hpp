#pragma once

#include <cmath>
#include <cstdint>

#include "numbers/wide_number.hpp"
#include "solvers/event/fixed_time.hpp"

namespace carom::event {

/// The clock of a wide run: its times are whole numbers of ticks, too, held in the wide number, in
/// which their differences are exact.
///
/// Holds: a tick is 2^8 units of rounding of the time it takes to cross the box.
template <>
class Clock<WideNumber> {
 public:
  using S = WideNumber;
  using Time = S;
  using At = const S&;

  static Time never() { return S::infinity(); }
  static Time ever() { return -power(S::bits() - 1); }
  static Time longest_flight() { return power(S::bits() - 2); }
  static Time epoch() { return power(S::bits() - 3); }

  static int bits() { return S::bits() - 8; }

  Clock() : Clock(1) {}
  explicit Clock(double crossing)
      : tick_(power(std::ilogb(crossing) - bits())), per_second_(1 / tick_) {}

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
    return number < kMost ? static_cast<std::int64_t>(number) : kMost;
  }
  static Time span(std::int64_t steps, int shift) { return ldexp(S(steps), shift); }
  static int shift_of(const Time& span) { return span < 1 ? 0 : ilogb(span); }

 private:
  static S power(int exponent) { return ldexp(S(1), exponent); }

  S tick_;
  S per_second_;
};

}  // namespace carom::event
