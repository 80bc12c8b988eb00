#include "solvers/event/domains/compiled.hpp"

CAROM_COMPILE_DOMAINS(Ballistic)
