#pragma once

#include "contact/event_any_law.hpp"
#include "solvers/event/physics.hpp"
#include "solvers/event/wide_clock.hpp"

namespace carom::event {

/// In as many digits as WidePrecision says.
using WidePhysics = Physics<WideNumber, AnyLaw>;

}  // namespace carom::event
