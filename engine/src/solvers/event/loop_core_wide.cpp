#include "solvers/event/compiled.hpp"
#include "solvers/event/wide_physics.hpp"

CAROM_COMPILE_EVENT(WidePhysics)
