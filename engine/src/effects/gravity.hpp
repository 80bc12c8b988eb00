#pragma once

#include "effects/flight.hpp"

namespace carom::effects {

/// What gravity adds in a step, without drag: the exact parabola of a uniform acceleration.
Glide fall(double acceleration, double step);

/// Bends the flight by the fall of its glide; fixed balls stay.
void gravity(Flight& flight);

}  // namespace carom::effects
