#include "fill/random.hpp"

#include <cmath>
#include <numbers>

namespace carom::scene {

namespace {

/// Spreads the bits of neighbouring numbers.
/// Source: Steele, Lea, Flood 2014 (splitmix64).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31);
}

}  // namespace

Random::Random(std::uint64_t seed, std::uint64_t stream) : bits_(mixed(seed ^ mixed(stream))) {}

// Source: Marsaglia's polar method, 1964.
double Random::gaussian() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  double x = 0;
  double y = 0;
  double s = 0;
  do {
    x = 2 * uniform() - 1;
    y = 2 * uniform() - 1;
    s = x * x + y * y;
  } while (s >= 1 || s == 0);
  const double factor = std::sqrt(-2 * portable_log(s) / s);
  spare_ = y * factor;
  has_spare_ = true;
  return x * factor;
}

double portable_log(double x) {
  int exponent = 0;
  double fraction = std::frexp(x, &exponent);  // exact, in [1/2, 1)
  if (fraction < std::numbers::sqrt2 / 2) {
    fraction *= 2;
    --exponent;
  }
  // ln f = 2 artanh((f - 1) / (f + 1)), whose argument is at most 0.172.
  const double z = (fraction - 1) / (fraction + 1);
  const double square = z * z;
  double sum = 0;
  for (int k = 23; k >= 1; k -= 2) sum = sum * square + 1.0 / k;
  return exponent * std::numbers::ln2 + 2 * z * sum;
}

}  // namespace carom::scene
