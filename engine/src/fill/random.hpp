#pragma once

#include <cstdint>
#include <random>

namespace carom::scene {

/// Random numbers that are the same on every machine: the bits of std::mt19937_64, which the
/// standard fixes, and from there only operations that IEEE 754 rounds correctly.
class Random {
 public:
  /// Streams of one seed are independent of each other.
  Random(std::uint64_t seed, std::uint64_t stream);

  /// Uniform in [0, 1): a multiple of 2^-53.
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  /// Normal with mean 0 and variance 1.
  double gaussian();

 private:
  std::mt19937_64 bits_;
  double spare_ = 0;
  bool has_spare_ = false;
};

/// The natural logarithm of a normal number by + - * / alone, right to a few units in the last
/// place; std::log may differ in its last bit from one library to the next.
double portable_log(double x);

}  // namespace carom::scene
