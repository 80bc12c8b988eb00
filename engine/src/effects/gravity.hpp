#pragma once

#include "effects/flight.hpp"

namespace carom::effects {

/// Bends the flight into the exact parabola of a uniform acceleration; fixed balls stay.
void gravity(Flight& flight, double acceleration);

}  // namespace carom::effects
