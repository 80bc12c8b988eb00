#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#if defined(__AVX__) && defined(__FMA__)
#include <immintrin.h>
#endif

// How lanes are passed depends on the processor's registers; they never leave a translation unit.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace carom::event {

/// Four numbers that are computed with side by side; each lane rounds as a plain double does.
// NOLINTNEXTLINE(modernize-use-using): `using` drops the attribute
typedef double Lanes __attribute__((vector_size(32)));
// NOLINTNEXTLINE(modernize-use-using)
typedef std::int64_t WholeLanes __attribute__((vector_size(32)));
inline constexpr std::uint32_t kLanes = 4;
/// The two axes side by side.
// NOLINTNEXTLINE(modernize-use-using)
typedef double TwoLanes __attribute__((vector_size(16)));
// NOLINTNEXTLINE(modernize-use-using)
typedef std::int64_t WholeTwoLanes __attribute__((vector_size(16)));

// What the compiler does not always see by itself.
#if defined(__AVX__) && defined(__FMA__)
/// a b + c, rounded once.
[[gnu::always_inline]] inline Lanes fused(Lanes a, Lanes b, Lanes c) {
  return _mm256_fmadd_pd(a, b, c);
}
[[gnu::always_inline]] inline Lanes square_root(Lanes a) {
  return _mm256_sqrt_pd(a);
}
/// The lesser and the greater, lane by lane; b where the two cannot be compared.
[[gnu::always_inline]] inline Lanes lesser(Lanes a, Lanes b) {
  return _mm256_min_pd(a, b);
}
[[gnu::always_inline]] inline Lanes greater(Lanes a, Lanes b) {
  return _mm256_max_pd(a, b);
}
/// a where the condition is true, b elsewhere.
[[gnu::always_inline]] inline Lanes choose(WholeLanes condition, Lanes a, Lanes b) {
  return _mm256_blendv_pd(b, a, std::bit_cast<Lanes>(condition));
}
/// Whether a comparison is true in some lane.
[[gnu::always_inline]] inline bool any(WholeLanes a) {
  return _mm256_movemask_pd(std::bit_cast<Lanes>(a)) != 0;
}
/// In which lanes: a bit for each.
[[gnu::always_inline]] inline std::uint32_t which(WholeLanes a) {
  return static_cast<std::uint32_t>(_mm256_movemask_pd(std::bit_cast<Lanes>(a)));
}
/// Whether it is true in more than one.
[[gnu::always_inline]] inline bool several(WholeLanes a) {
  const int true_in = _mm256_movemask_pd(std::bit_cast<Lanes>(a));
  return (true_in & (true_in - 1)) != 0;
}
#else
[[gnu::always_inline]] inline Lanes fused(Lanes a, Lanes b, Lanes c) {
  return Lanes{std::fma(a[0], b[0], c[0]), std::fma(a[1], b[1], c[1]), std::fma(a[2], b[2], c[2]),
               std::fma(a[3], b[3], c[3])};
}
[[gnu::always_inline]] inline Lanes square_root(Lanes a) {
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
[[gnu::always_inline]] inline Lanes lesser(Lanes a, Lanes b) {
  return a < b ? a : b;
}
[[gnu::always_inline]] inline Lanes greater(Lanes a, Lanes b) {
  return a > b ? a : b;
}
[[gnu::always_inline]] inline Lanes choose(WholeLanes condition, Lanes a, Lanes b) {
  return condition ? a : b;
}
[[gnu::always_inline]] inline bool any(WholeLanes a) {
  return (a[0] | a[1] | a[2] | a[3]) != 0;
}
[[gnu::always_inline]] inline std::uint32_t which(WholeLanes a) {
  return (a[0] != 0 ? 1U : 0U) | (a[1] != 0 ? 2U : 0U) | (a[2] != 0 ? 4U : 0U) |
         (a[3] != 0 ? 8U : 0U);
}
[[gnu::always_inline]] inline bool several(WholeLanes a) {
  return a[0] + a[1] + a[2] + a[3] < -1;
}
#endif
[[gnu::always_inline]] inline Lanes all(double a) {
  return Lanes{a, a, a, a};
}
[[gnu::always_inline]] inline WholeLanes all(std::int64_t a) {
  return WholeLanes{a, a, a, a};
}
[[gnu::always_inline]] inline std::int64_t least(WholeLanes a) {
  const std::int64_t low = a[0] < a[1] ? a[0] : a[1];
  const std::int64_t high = a[2] < a[3] ? a[2] : a[3];
  return low < high ? low : high;
}
/// The number of the first lane that holds `value`.
/// REQUIRES: one does.
[[gnu::always_inline]] inline std::uint32_t lane_of(Lanes a, double value) {
  return static_cast<std::uint32_t>(std::countr_zero(which(a == all(value))));
}
[[gnu::always_inline]] inline double least(Lanes a) {
  const double low = a[0] < a[2] ? a[0] : a[2];
  const double high = a[1] < a[3] ? a[1] : a[3];
  return low < high ? low : high;
}
[[gnu::always_inline]] inline Lanes absolute(Lanes a) {
  constexpr auto kRest = std::numeric_limits<std::int64_t>::max();
  return std::bit_cast<Lanes>(std::bit_cast<WholeLanes>(a) & all(kRest));
}

/// The bits that tell the signs.
[[gnu::always_inline]] inline WholeTwoLanes signs(TwoLanes a) {
  constexpr auto kSign = std::numeric_limits<std::int64_t>::min();
  return std::bit_cast<WholeTwoLanes>(a) & WholeTwoLanes{kSign, kSign};
}
/// Times 1 or -1.
[[gnu::always_inline]] inline TwoLanes with_signs(TwoLanes a, WholeTwoLanes signs) {
  return std::bit_cast<TwoLanes>(std::bit_cast<WholeTwoLanes>(a) ^ signs);
}

template <class All>
struct Unzipped {
  All first;
  All second;
};
/// The first numbers of four pairs, and the second ones.
template <class All, class Pair>
[[gnu::always_inline]] inline Unzipped<All> unzip(const Pair& a, const Pair& b, const Pair& c,
                                                  const Pair& d) {
  const All even = __builtin_shufflevector(a, c, 0, 1, 2, 3);
  const All odd = __builtin_shufflevector(b, d, 0, 1, 2, 3);
  return {__builtin_shufflevector(even, odd, 0, 4, 2, 6),
          __builtin_shufflevector(even, odd, 1, 5, 3, 7)};
}

}  // namespace carom::event
