#pragma once

#include <cstdint>

#include "solvers/event/fixed_time.hpp"

namespace carom::event {

using Index = std::uint32_t;

/// What a ball meets next, where that is not another ball.
inline constexpr Index kFirstMark = 0xfffffff0U;
inline constexpr Index kUnknown = 0xfffffff0U;  ///< nothing before its time: look again then
inline constexpr Index kCarry = 0xfffffff1U;    ///< the flight is long enough: it starts again
inline constexpr Index kSettles = 0xfffffff2U;  ///< what slides along a wall stops sliding
inline constexpr Index kWalls = 0xfffffff4U;    ///< + 2 axis, + 1 for the upper one

/// The flight of a ball: where, when and how fast it left its last impact.  Only impacts change it.
template <class S>
struct BallFlight {
  using Time = typename Clock<S>::Time;

  S x = 0;  ///< at `start`, as are y, vx and vy
  S y = 0;
  S vx = 0;
  S vy = 0;
  Time start = 0;
  Index species = 0;  ///< its radius and mass, in the table of species
};

/// A flight, and what is known of its end: one cache line in double.
///
/// Holds: what is known of the end may be early without changing a bit of the result.
template <class S>
struct alignas(64) BasicDisk : BallFlight<S> {
  using Time = typename Clock<S>::Time;

  Index partner = kUnknown;
  Time meets = Clock<S>::never();   ///< when it meets `partner`; no impact of its comes earlier
  Time leaves = Clock<S>::never();  ///< when it leaves the square for which neighbours are listed

  [[nodiscard]] const Time& due() const { return meets < leaves ? meets : leaves; }
};

using Disk = BasicDisk<double>;
static_assert(sizeof(Disk) == 64);

}  // namespace carom::event
