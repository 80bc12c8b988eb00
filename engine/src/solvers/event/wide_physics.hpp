#pragma once

#include "solvers/event/physics.hpp"
#include "solvers/event/wide_clock.hpp"
#include "trajectory/any_law.hpp"

namespace carom::event {

/// In as many digits as WidePrecision says.
using WidePhysics = Physics<WideNumber, AnyLaw>;

}  // namespace carom::event
