#pragma once

#include <array>
#include <cstddef>

#include "contact/dissipation.hpp"
#include "state/balls.hpp"

namespace carom {

/// What one step does along an axis to a ball that flies free, whatever its place and speed v:
/// it moves by reach v + fall, and its velocity becomes keep v + gain.
///
/// Worked out once for each step length by the effects that are named: see effects/gravity.hpp and
/// effects/drag.hpp.
struct Glide {
  double reach = 0;
  double keep = 1;
  double fall = 0;
  double gain = 0;
  DragLoss drag_loss{};     ///< with drag
  double acceleration = 0;  ///< that it was worked out for
};

/// The motion of some balls along one axis in one step, while it is being worked out: every effect
/// that acts on the flight adds its part, then the sides of the box have their say.  Which effects
/// take part is decided for a block of balls at a time, never for a ball.
///
/// Holds: `position`, `velocity` are those before the step; `moved` and `after` those it leads to.
struct Flight {
  static constexpr std::size_t kBlock = 128;
  using Lanes = std::array<double, kBlock>;

  std::size_t axis = 0;
  std::size_t begin = 0;  ///< the number of the first ball
  std::size_t count = 0;  ///< at most kBlock
  double step = 0;
  Glide glide;
  const double* position = nullptr;
  const double* velocity = nullptr;
  const double* radius = nullptr;
  const double* inverse_mass = nullptr;
  const double* pull = nullptr;  ///< by attraction: `velocity` holds half a step of it already
  const double* mass = nullptr;
  double* lost = nullptr;   ///< adds up what restitution and drag take; null: they do not
  alignas(64) Lanes moved;  ///< displacement, later the new position
  alignas(64) Lanes after;  ///< velocity after the step
};

/// Prepares the flight of balls [begin, end) along an axis.
inline void prepare(Flight& flight, const Balls& balls, std::size_t axis, std::size_t begin,
                    std::size_t end, double step, const Glide& glide) {
  flight.axis = axis;
  flight.begin = begin;
  flight.count = end - begin;
  flight.step = step;
  flight.glide = glide;
  flight.position = balls.position[axis].data() + begin;
  flight.velocity = balls.velocity[axis].data() + begin;
  flight.radius = balls.radius.data() + begin;
  flight.inverse_mass = balls.inverse_mass.data() + begin;
  flight.mass = balls.mass.data() + begin;
  flight.pull = balls.pull[axis].size() > 0 ? balls.pull[axis].data() + begin : nullptr;
}

/// Straight on, at constant speed.
inline void straight(Flight& flight) {
  for (std::size_t k = 0; k < flight.count; ++k) {
    flight.moved[k] = flight.velocity[k] * flight.step;
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
