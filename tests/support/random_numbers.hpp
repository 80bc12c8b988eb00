#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace carom::test {

/// Numbers drawn the same way on every machine.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  double angle() { return between(-std::numbers::pi, std::numbers::pi); }
  double sign() { return (engine_() & 1) != 0 ? 1.0 : -1.0; }
  int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace carom::test
