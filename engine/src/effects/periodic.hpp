#pragma once

#include <cstdint>

#include "effects/flight.hpp"
#include "state/domain.hpp"

namespace carom::effects {

/// Takes balls that have left a periodic axis to the other end; `turns`, if there is one, counts.
void wrap(Flight& flight, const Domain& domain, std::int64_t* turns);

}  // namespace carom::effects
