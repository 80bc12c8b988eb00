#include "effects/gravity.hpp"

namespace carom::effects {

Glide fall(double acceleration, double step) {
  const double gain = acceleration * step;
  return {step, 1, gain * step / 2, gain};
}

void gravity(Flight& flight) {
  const double gain = flight.glide.gain;
  const double fall = flight.glide.fall;
  for (std::size_t k = 0; k < flight.count; ++k) {
    const bool moves = flight.inverse_mass[k] > 0;
    flight.moved[k] += moves ? fall : 0;
    flight.after[k] += moves ? gain : 0;
  }
}

}  // namespace carom::effects
