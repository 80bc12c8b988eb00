#include "solvers/event/islands/stepped_flight.hpp"

#include <cmath>

namespace carom::event {

double SteppedFlight::way(double elapsed) const {
  return fading > 0 ? -std::expm1(-fading * elapsed) / fading : elapsed;
}

// Under an acceleration of 1 a ball at rest goes (T - way(T)) / k in a time of T.
double SteppedFlight::given() const {
  const double z = fading * seconds;
  constexpr double kSmall = 0x1p-5;
  if (z < kSmall) {
    const double square = z * z;
    return seconds * (0.5 + z / 12 * (1 - square / 60 * (1 - square / 42)));
  }
  return seconds * (-1 / std::expm1(-z) - 1 / z);
}

double SteppedFlight::owed(double elapsed) const {
  return way(elapsed) - given() * std::exp(-fading * elapsed);
}

double SteppedFlight::ahead(double elapsed) const {
  const double half = fading > 0 ? std::tanh(fading * seconds / 2) / fading : seconds / 2;
  return way(seconds - elapsed) - half * std::exp(-fading * (seconds - elapsed));
}

}  // namespace carom::event
