#include "solvers/event/compiled.hpp"

CAROM_COMPILE_EVENT(Ballistic)
