#pragma once

namespace carom::event {

// What carries a ball, beside the axes along which walls do.
inline constexpr unsigned kLying = 3;     ///< in a corner, or on the very top of a fixed ball
inline constexpr unsigned kSlides = 4;    ///< along a wall with friction: + 2 axis, + 1 if forwards
inline constexpr unsigned kRolls = 8;     ///< along a wall: + axis
inline constexpr unsigned kSpins = 10;    ///< in a corner with friction
inline constexpr unsigned kResting = 11;  ///< in an island that rests
inline constexpr unsigned kStepped = 12;  ///< in an island that moves
inline constexpr unsigned kJoins = 13;    ///< in an island from its next step on

/// The axes along which walls support what has this support: 1 for x, 2 for y.
inline unsigned axes_of(unsigned support) {
  if (support <= kLying) return support;
  if (support < kRolls) return 1U << ((support - kSlides) / 2);
  if (support < kSpins) return 1U << (support - kRolls);
  return support == kSpins ? kLying : 0U;
}

}  // namespace carom::event
