#include "solvers/event/compiled.hpp"

CAROM_COMPILE_EVENT(Free)

template class carom::event::Windows<carom::event::Free>;
