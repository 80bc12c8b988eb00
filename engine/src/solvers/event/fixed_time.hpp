#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace carom::event {

/// Time as a whole number of ticks, so that differences of times are exact and their order is one
/// comparison.
using FixedTime = std::int64_t;

inline constexpr FixedTime kNever = std::numeric_limits<FixedTime>::max();
/// No flight lasts longer: it is then carried on from where it is.
inline constexpr FixedTime kLongestFlight = FixedTime{1} << 61;
/// When the flight of a fixed ball began: before all others.
inline constexpr FixedTime kEver = -(FixedTime{1} << 62);

/// The clock of a run in scalars S: what a time is, and how long a tick.  A tick is a power of two,
/// taken from the scene's own scale.
///
/// Units: seconds.
/// Holds: in one tick a ball that crosses the box in `crossing` moves so little that rounding a
/// time down to a tick changes no place by more than its own rounding does.
template <class S>
class Clock;

/// In double 2^-55 of the box.
template <>
class Clock<double> {
 public:
  using Time = FixedTime;
  using At = FixedTime;  ///< a time that is handed over
  static constexpr int kBits = 55;
  static constexpr int bits() { return kBits; }
  static constexpr int kSlowest = 900;  ///< binary orders of magnitude that a double has room for

  static constexpr Time never() { return kNever; }
  static constexpr Time ever() { return kEver; }
  static constexpr Time longest_flight() { return kLongestFlight; }
  /// Time is counted again from 0 after so many ticks.
  static constexpr Time epoch() { return Time{1} << 60; }

  Clock() = default;
  /// REQUIRES: `crossing` > 0, the shortest time in which something crosses the box.
  explicit Clock(double crossing)
      : tick_(std::ldexp(1.0, std::clamp(std::ilogb(crossing), -kSlowest, kSlowest) - kBits)),
        per_second_(1 / tick_) {}

  /// REQUIRES: a power of two.
  static Clock of_tick(double tick) {
    Clock clock;
    clock.tick_ = tick;
    clock.per_second_ = 1 / tick;
    return clock;
  }

  [[nodiscard]] double seconds(Time ticks) const { return static_cast<double>(ticks) * tick_; }
  /// Rounded down; never() where no flight lasts that long.
  /// REQUIRES: not negative.
  [[nodiscard]] Time ticks(double seconds) const {
    const double exact = seconds * per_second_;
    return exact < static_cast<double>(kLongestFlight) ? static_cast<Time>(exact) : kNever;
  }
  /// Rounded down.
  /// REQUIRES: not negative.
  static Time whole(double ticks) { return static_cast<Time>(ticks); }
  [[nodiscard]] double tick() const { return tick_; }
  [[nodiscard]] double per_second() const { return per_second_; }
  /// The clock's resolution: what happens nearer together than this is at one instant.
  [[nodiscard]] double resolution() const { return tick_; }

  // Times in steps of 2^shift ticks.
  static std::int64_t steps(Time span, int shift) { return span >> shift; }
  static Time span(std::int64_t steps, int shift) { return steps << shift; }
  /// The longest step that is not longer than `span`.
  static int shift_of(Time span) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(span < 1 ? 1 : span))) - 1;
  }

 private:
  double tick_ = 0x1p-55;
  double per_second_ = 0x1p55;
};

using FixedTimeClock = Clock<double>;

}  // namespace carom::event
