#pragma once

#include <cmath>
#include <cstdint>

// How lanes are passed depends on the processor's registers; they never leave a translation unit.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace carom::event {

/// Four numbers that are computed with side by side; each lane rounds as a plain double does.
// NOLINTNEXTLINE(modernize-use-using): `using` drops the attribute
typedef double Lanes __attribute__((vector_size(32)));
// NOLINTNEXTLINE(modernize-use-using)
typedef std::int64_t WholeLanes __attribute__((vector_size(32)));
inline constexpr std::uint32_t kLanes = 4;

/// a b + c, rounded once.
inline Lanes fused(Lanes a, Lanes b, Lanes c) {
  return Lanes{std::fma(a[0], b[0], c[0]), std::fma(a[1], b[1], c[1]), std::fma(a[2], b[2], c[2]),
               std::fma(a[3], b[3], c[3])};
}
inline Lanes square_root(Lanes a) {
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}

/// Lane l of the four results holds number l of each row: (x, y, vx, vy) of four balls becomes four
/// x, four y, four vx, four vy.
inline void transpose(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
  const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lanes ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// The difference of two coordinates, the shorter way round an axis of length `period`; both are
/// infinite on an axis that is not periodic.
template <class Real>
inline Real nearest(Real difference, Real period, Real half) {
  return difference > half ? difference - period
                           : (difference < -half ? difference + period : difference);
}

}  // namespace carom::event
