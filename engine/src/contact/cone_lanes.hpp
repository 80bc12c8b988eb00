#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "numbers/orderless_sum.hpp"

// How lanes are passed depends on the processor's registers; they never leave the sources of cone
// islands.
#pragma GCC diagnostic ignored "-Wpsabi"

/// Several numbers side by side.  For sources alone.
namespace carom::event::cone {

// Columns are whole numbers of these: maxima, and sums of terms that are on one grid, have the
// same bits in any order.
inline constexpr std::size_t kLanes = 8;
// NOLINTNEXTLINE(modernize-use-using): `using` drops the attribute
typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double)), aligned(8), may_alias));

inline const Lanes& lanes(const double* at) {
  return *reinterpret_cast<const Lanes*>(at);
}
inline Lanes& lanes(double* at) {
  return *reinterpret_cast<Lanes*>(at);
}
inline Lanes size_of(const Lanes& a) {
  return a < 0 ? -a : a;
}
inline Lanes larger_of(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}
inline double largest(const Lanes& a) {
  double result = a[0];
  for (std::size_t k = 1; k < kLanes; ++k) result = std::max(result, a[k]);
  return result;
}
inline double sum(const Lanes& a) {
  double result = 0;
  for (std::size_t k = 0; k < kLanes; ++k) result += a[k];
  return result;
}

/// Terms of two sums.
struct Two {
  Lanes one;
  Lanes other;
};

/// Two sums over n terms each.
template <class Terms>
std::array<double, 2> sums(std::size_t n, const Terms& terms) {
  Two most{};
  for (std::size_t k = 0; k < n; k += kLanes) {
    const Two now = terms(k);
    most.one = larger_of(most.one, size_of(now.one));
    most.other = larger_of(most.other, size_of(now.other));
  }
  const auto count = static_cast<double>(n);
  const double one = OrderlessSum<double>(largest(most.one) * count).grid();
  const double other = OrderlessSum<double>(largest(most.other) * count).grid();
  Two total{};
  for (std::size_t k = 0; k < n; k += kLanes) {
    const Two now = terms(k);
    total.one += (now.one + one) - one;
    total.other += (now.other + other) - other;
  }
  return {sum(total.one), sum(total.other)};
}

}  // namespace carom::event::cone
