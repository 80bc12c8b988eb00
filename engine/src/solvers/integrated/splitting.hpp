#pragma once

#include <array>
#include <cstddef>

namespace carom {

/// A symmetric splitting of fourth order, five velocity Verlet steps in a row: the pull acts for a
/// fraction `pull[0]` of the step, the balls fly for `flight[0]`, and so on, ending with the pull.
/// The flight is exact whatever else it is under, such as gravity and drag.
///
/// Each step is eight of them.  There are splittings that reach the same error with half the sums
/// (Blanes and Moan 2002); but of those the fourth order shows only at steps finer than anyone
/// takes, and what is behind it changes its sign with the eccentricity of an orbit.
/// Source: Suzuki,
/// Fractal decomposition of exponential operators, Phys. Lett. A 146 (1990) 319.
struct Splitting {
  static constexpr std::size_t kStages = 5;
  static constexpr std::size_t kInAStep = 8;

  static constexpr double kPart = 0.41449077179437573714;  // 1 / (4 - 4^(1/3))
  static constexpr double kMiddle = 1 - 4 * kPart;         // backwards

  static constexpr std::array<double, kStages + 1> kPull{
      kPart / 2, kPart, (kPart + kMiddle) / 2, (kPart + kMiddle) / 2, kPart, kPart / 2};
  static constexpr std::array<double, kStages> kFlight{kPart, kPart, kMiddle, kPart, kPart};
};

}  // namespace carom
