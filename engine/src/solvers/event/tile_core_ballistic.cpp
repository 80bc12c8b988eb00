#include "solvers/event/compiled.hpp"

CAROM_COMPILE_EVENT(Ballistic)

template class carom::event::Windows<carom::event::Ballistic>;
