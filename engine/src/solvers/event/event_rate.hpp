#pragma once

#include <cstddef>

namespace carom::event {

/// What a guess of how often balls have events goes by.  In the units of the scene.
struct BallsOfBox {
  std::size_t count = 0;
  double area = 0;  ///< of the box
  double gravity = 0;
  double squares = 0;    ///< of the speeds, in sum
  double diameters = 0;  ///< in sum
  double covered = 0;    ///< of the area, by balls

  void add(double radius, double square_speed);
};

/// Events a second of all of them: four for each impact, of which there are as many as in a gas of
/// that packing.
/// Source: J. M. Hansen and I. R. McDonald, Theory of Simple Liquids, for the contact value (1 -
/// p/2) / (1 - p)^2 of a gas of disks.
[[nodiscard]] double guessed_event_rate(const BallsOfBox& balls);

}  // namespace carom::event
