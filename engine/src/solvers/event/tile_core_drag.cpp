#include "solvers/event/compiled.hpp"

CAROM_COMPILE_EVENT(Drag)

template class carom::event::Windows<carom::event::Drag>;
