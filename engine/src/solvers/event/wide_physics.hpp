#pragma once

#include "solvers/event/physics.hpp"
#include "solvers/event/wide_scalars.hpp"

namespace carom::event {

using Any34 = Physics<Digits34, AnyLaw>;
using Any50 = Physics<Digits50, AnyLaw>;
using Any100 = Physics<Digits100, AnyLaw>;
using Any34Rubbing = RubbingOf<Any34>::Type;
using Any50Rubbing = RubbingOf<Any50>::Type;
using Any100Rubbing = RubbingOf<Any100>::Type;

}  // namespace carom::event
