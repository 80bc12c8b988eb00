#pragma once

#include <cstdint>

#include "solvers/event/ticks.hpp"

namespace carom::event {

using Index = std::uint32_t;

/// What a ball meets next, where that is not another ball.
inline constexpr Index kFirstMark = 0xfffffff0U;
inline constexpr Index kUnknown = 0xfffffff0U;  ///< nothing before its time: look again then
inline constexpr Index kCarry = 0xfffffff1U;    ///< the flight is long enough: it starts anew
inline constexpr Index kWalls = 0xfffffff4U;    ///< + 2 axis, + 1 for the upper one

/// When the flight of a fixed ball began: before all others.
inline constexpr Ticks kEver = -(Ticks{1} << 62);

/// A ball's flight, and what is known of its end: one cache line.
///
/// Holds: the flight is where, when and how fast the ball left its last impact, and changes only
/// there.  The rest is bookkeeping: it may be early without changing a bit of the result.
struct alignas(64) Disk {
  double x = 0;  ///< at `start`, as are y, vx and vy
  double y = 0;
  double vx = 0;
  double vy = 0;
  Ticks start = 0;
  Ticks meets = kNever;   ///< when it meets `partner`; no impact of its comes earlier
  Ticks leaves = kNever;  ///< when it leaves the square for which its neighbours are listed
  Index partner = kUnknown;
  Index kind = 0;  ///< its radius and mass, in the table of kinds

  [[nodiscard]] Ticks due() const { return meets < leaves ? meets : leaves; }
};

}  // namespace carom::event
