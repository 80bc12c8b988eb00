#pragma once

#include "effects/flight.hpp"

namespace carom::effects {

/// What a step does under dv/dt = a - rate v: the exact solution
///     v' = v exp(-rate h) + a s,    x' = x + v s + a (h - s) / rate,    s = (1 - exp(-rate h)) /
///     rate
/// for a uniform acceleration a.  A rate of 0 gives the parabola.
Glide slowed(double rate, double step, double acceleration);

/// Flies on, slowed down as the flight's glide says.
void drag(Flight& flight);

/// The speed of arrival after a way of `distance`, of a ball that started with `velocity` towards
/// where it arrives and is pulled there by `pull`: exact without a pull, else the loss along the
/// way is taken from the mean of the two speeds.
double arrival_under_drag(double rate, double velocity, double pull, double distance);

}  // namespace carom::effects
