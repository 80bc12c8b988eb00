#include "carom/measurements.hpp"

#include <cmath>

namespace carom {

double Measurements::relative_energy_error() const {
  const double expected = energy_initial + energy_input;
  const double difference = energy_final - expected;
  return expected == 0 ? difference : difference / std::abs(expected);
}

}  // namespace carom
