#pragma once

#include <cstddef>

namespace carom::scene {

/// The sizes a scene may have.

/// Lengths, masses and times: their fourth powers, as contact times need them, neither vanish nor
/// overflow in double precision.
inline constexpr double kSmallest = 1e-70;
inline constexpr double kLargest = 1e70;
/// Balls in all.
inline constexpr std::size_t kMostBalls = 10'000'000;
inline constexpr std::size_t kMostWorkers = 1'000'000;
/// Side of the box to radius of a ball: beyond this a position does not tell a ball's parts apart.
inline constexpr double kBoxToRadius = 1e12;
/// Steps and frames are counted exactly up to here.
inline constexpr double kMostSteps = 0x1p53;
/// Impacts that are followed one by one: as often may a ball cross the box.
inline constexpr double kMostCrossings = 1e10;
/// What a saved run has counted of jams: as often is one found before the run ends, and so many
/// spans of time does it last.
inline constexpr unsigned kMostJamsFound = 1000;
inline constexpr unsigned kMostJamSpans = 64;
/// Overlapping pairs that are told one by one.
inline constexpr std::size_t kMostOverlapsTold = 20;

}  // namespace carom::scene
