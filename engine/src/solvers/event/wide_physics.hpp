#pragma once

#include "solvers/event/physics.hpp"
#include "solvers/event/wide_scalars.hpp"

namespace carom::event {

using Any34 = Physics<Digits34, AnyLaw>;
using Any50 = Physics<Digits50, AnyLaw>;
using Any100 = Physics<Digits100, AnyLaw>;

}  // namespace carom::event
