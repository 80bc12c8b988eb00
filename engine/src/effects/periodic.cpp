#include "effects/periodic.hpp"

#include <cmath>

namespace carom::effects {

void wrap(Flight& flight, const Domain& domain, std::int64_t* turns) {
  const double lower = domain.lower[flight.axis];
  const double upper = domain.upper[flight.axis];
  for (std::size_t k = 0; k < flight.count; ++k) {
    const double x = flight.moved[k];
    if (x >= lower && x <= upper) continue;
    flight.moved[k] = std::isfinite(x) ? domain.wrapped(flight.axis, x) : flight.position[k];
    if (turns != nullptr && std::isfinite(x)) {
      turns[flight.begin + k] +=
          static_cast<std::int64_t>(std::rint((x - flight.moved[k]) / domain.period[flight.axis]));
    }
  }
}

}  // namespace carom::effects
