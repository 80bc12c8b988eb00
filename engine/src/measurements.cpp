#include "carom/measurements.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

double Measurements::relative_energy_error() const {
  const double expected = energy_initial + energy_input - energy_dissipated;
  const double difference = std::abs(energy_final - expected);
  const double largest =
      std::max({std::abs(energy_initial), energy_largest, std::abs(energy_final), kinetic_final});
  return largest > 0 ? difference / largest : difference;
}

}  // namespace carom
