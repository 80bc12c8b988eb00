#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace carom::event {

/// Time as a whole number of ticks, so that differences of times are exact and their order is one
/// comparison of integers.
using Ticks = std::int64_t;

inline constexpr Ticks kNever = std::numeric_limits<Ticks>::max();
/// No flight lasts longer: it is then carried on from where it is.
inline constexpr Ticks kLongestFlight = Ticks{1} << 61;

/// The length of a tick: a power of two, taken from the scene's own scale.
///
/// Units: seconds.
/// Holds: in one tick a ball that crosses the box in `crossing` moves 2^-55 of the box at most, so
/// that rounding a time down to a tick changes no place by more than its own rounding does.
class TickScale {
 public:
  static constexpr int kBits = 55;

  TickScale() = default;
  /// REQUIRES: `crossing` > 0, the shortest time in which something crosses the box.
  explicit TickScale(double crossing)
      : tick_(std::ldexp(1.0, std::ilogb(crossing) - kBits)), per_second_(1 / tick_) {}

  [[nodiscard]] double seconds(Ticks ticks) const { return static_cast<double>(ticks) * tick_; }
  /// Rounded down; kNever where no flight lasts that long.  REQUIRES: not negative.
  [[nodiscard]] Ticks ticks(double seconds) const {
    const double exact = seconds * per_second_;
    return exact < static_cast<double>(kLongestFlight) ? static_cast<Ticks>(exact) : kNever;
  }
  [[nodiscard]] double tick() const { return tick_; }
  [[nodiscard]] double per_second() const { return per_second_; }

 private:
  double tick_ = 0x1p-55;
  double per_second_ = 0x1p55;
};

}  // namespace carom::event
