#pragma once

#include <array>
#include <cstddef>

#include "state/balls.hpp"

namespace carom {

/// The motion of some balls along one axis in one step, while it is being worked out: every effect
/// that acts on the flight adds its part, then the sides of the box have their say.
///
/// Holds: `position`, `velocity` are those before the step; `moved` and `after` those it leads to.
struct Flight {
  static constexpr std::size_t kBlock = 128;

  std::size_t axis = 0;
  std::size_t begin = 0;  ///< the number of the first ball
  std::size_t count = 0;  ///< at most kBlock
  double step = 0;
  const double* position = nullptr;
  const double* velocity = nullptr;
  const double* radius = nullptr;
  const double* inverse_mass = nullptr;
  alignas(64) std::array<double, kBlock> moved;  ///< displacement, later the new position
  alignas(64) std::array<double, kBlock> after;  ///< velocity after the step
};

/// Starts the flight of balls [begin, end) along an axis: straight, at constant speed.
inline void start(Flight& flight, const Balls& balls, std::size_t axis, std::size_t begin,
                  std::size_t end, double step) {
  flight.axis = axis;
  flight.begin = begin;
  flight.count = end - begin;
  flight.step = step;
  flight.position = balls.position[axis].data() + begin;
  flight.velocity = balls.velocity[axis].data() + begin;
  flight.radius = balls.radius.data() + begin;
  flight.inverse_mass = balls.inverse_mass.data() + begin;
  for (std::size_t k = 0; k < flight.count; ++k) {
    flight.moved[k] = flight.velocity[k] * step;
    flight.after[k] = flight.velocity[k];
  }
}

/// Ends the free part of the flight: from here on `moved` is the new position.
inline void land(Flight& flight) {
  for (std::size_t k = 0; k < flight.count; ++k) flight.moved[k] += flight.position[k];
}

/// Hands the outcome to the balls.
inline void store(const Flight& flight, Balls& balls) {
  double* position = balls.position[flight.axis].data() + flight.begin;
  double* velocity = balls.velocity[flight.axis].data() + flight.begin;
  for (std::size_t k = 0; k < flight.count; ++k) {
    position[k] = flight.moved[k];
    velocity[k] = flight.after[k];
  }
}

}  // namespace carom
