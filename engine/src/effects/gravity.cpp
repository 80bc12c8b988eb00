#include "effects/gravity.hpp"

namespace carom::effects {

void gravity(Flight& flight, double acceleration) {
  const double gain = acceleration * flight.step;
  const double fall = gain * flight.step / 2;
  for (std::size_t k = 0; k < flight.count; ++k) {
    const bool moves = flight.inverse_mass[k] > 0;
    flight.moved[k] += moves ? fall : 0;
    flight.after[k] += moves ? gain : 0;
  }
}

}  // namespace carom::effects
