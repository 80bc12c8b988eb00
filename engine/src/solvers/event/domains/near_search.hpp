#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "solvers/event/domains/near_lists.hpp"
#include "solvers/event/lanes.hpp"

namespace carom::event {

/// Finds which of many places are near to one of them, eight at a time.
///
/// Places are in single precision: those found may be a little farther away than asked for, and
/// none is missed that is not.
class NearSearch {
 public:
  static constexpr std::uint32_t kAtATime = 8;

  /// `half`: of the plane that the places are in, from its middle; `periods`: 0 where an axis does
  /// not wrap; `reach`: to be near, without the two radii; `radius`: where all have the same.
  void reset(std::size_t balls, const std::array<double, 2>& half,
             const std::array<double, 2>& periods, double reach,
             std::optional<double> radius = std::nullopt) {
    constexpr float kFar = 1e18F;
    // Those behind the last are read, too.
    x_.resize(balls + kAtATime);
    y_.resize(balls + kAtATime);
    std::fill_n(x_.end() - kAtATime, kAtATime, kFar);
    std::fill_n(y_.end() - kAtATime, kAtATime, kFar);
    equal_ = radius.has_value();
    radius_.assign(equal_ ? 0 : balls + kAtATime, 0);
    wraps_ = periods[0] > 0 || periods[1] > 0;
    period_ = {static_cast<float>(periods[0]), static_cast<float>(periods[1])};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      per_[axis] = periods[axis] > 0 ? static_cast<float>(1 / periods[axis]) : 0;
    }
    reach += 2 * radius.value_or(0) + 8 * 0x1p-24 * (half[0] + half[1]);
    reach_ = static_cast<float>(reach * (1 + 0x1p-16));
  }
  void set(std::uint32_t k, double x, double y, double radius) {
    x_[k] = static_cast<float>(x);
    y_[k] = static_cast<float>(y);
    if (!equal_) radius_[k] = static_cast<float>(radius);
  }
  void move(std::uint32_t k, float x, float y) {
    x_[k] = x;
    y_[k] = y;
  }

  static constexpr std::size_t kBytesOfBall = 3 * sizeof(float);
  [[nodiscard]] std::size_t bytes() const { return x_.capacity() * kBytesOfBall; }

  /// Calls visit(k, mask) for each eight places from `first` to `last`: bit b of the mask tells
  /// whether place k + b is near to place i and another one.
  template <class Visit>
  [[gnu::always_inline]] void each_group(std::uint32_t i, std::uint32_t first, std::uint32_t last,
                                         const Visit& visit) const {
    for (std::uint32_t k = first; k < last; k += kAtATime) {
      const std::uint64_t asked = (std::uint64_t{1} << std::min(last - k, kAtATime)) - 1;
      const std::uint64_t me = std::uint64_t{1} << std::min(i - k, 63U);
      visit(k, near_mask(i, Row{k}) & static_cast<std::uint32_t>(asked & ~me));
    }
  }
  /// Calls visit(slots, mask) for each eight of the places in `others`: bit b of the mask tells
  /// whether place slots[b] is near to place i.
  /// REQUIRES: behind the last of them seven more can be read.
  template <class Visit>
  [[gnu::always_inline]] void each_of(std::uint32_t i, const Slot* others, std::uint32_t count,
                                      const Visit& visit) const {
    for (std::uint32_t k = 0; k < count; k += kAtATime) {
      const std::uint32_t asked = (1U << std::min(count - k, kAtATime)) - 1;
      visit(others + k, near_mask(i, Picked{others + k}) & asked);
    }
  }
  /// 1: place k is near to place i, and another one; else 0.
  [[nodiscard]] std::uint32_t near(std::uint32_t i, std::uint32_t k) const {
    return i == k ? 0 : near_mask(i, Row{k}) & 1U;
  }

 private:
  /// Which eight are asked for: next to each other,
  struct Row {
    std::uint32_t first;
    [[nodiscard]] std::uint32_t operator[](std::uint32_t l) const { return first + l; }
#if defined(__AVX2__)
    [[nodiscard]] __m256 of(const std::vector<float>& all) const {
      return _mm256_loadu_ps(&all[first]);
    }
#endif
  };
  /// or one by one.
  struct Picked {
    const Slot* slots;
    [[nodiscard]] std::uint32_t operator[](std::uint32_t l) const { return slots[l]; }
#if defined(__AVX2__)
    [[nodiscard]] __m256 of(const std::vector<float>& all) const {
      const __m128i eight = _mm_loadu_si128(reinterpret_cast<const __m128i*>(slots));
      return _mm256_i32gather_ps(all.data(), _mm256_cvtepu16_epi32(eight), sizeof(float));
    }
#endif
  };

  template <class Eight>
  [[nodiscard, gnu::always_inline]] std::uint32_t near_mask(std::uint32_t i,
                                                            const Eight& others) const {
#if defined(__AVX2__) && defined(__FMA__)
    constexpr int kNearest = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;
    const auto shorter = [](__m256 d, float period, float per) {
      const __m256 turns = _mm256_round_ps(_mm256_mul_ps(d, _mm256_set1_ps(per)), kNearest);
      return _mm256_fnmadd_ps(_mm256_set1_ps(period), turns, d);
    };
    __m256 dx = _mm256_sub_ps(_mm256_set1_ps(x_[i]), others.of(x_));
    __m256 dy = _mm256_sub_ps(_mm256_set1_ps(y_[i]), others.of(y_));
    if (wraps_) {
      dx = shorter(dx, period_[0], per_[0]);
      dy = shorter(dy, period_[1], per_[1]);
    }
    __m256 reach = _mm256_set1_ps(reach_);
    if (!equal_) {
      reach = _mm256_add_ps(reach, _mm256_add_ps(_mm256_set1_ps(radius_[i]), others.of(radius_)));
    }
    const __m256 square = _mm256_fmadd_ps(dx, dx, _mm256_mul_ps(dy, dy));
    return static_cast<std::uint32_t>(
        _mm256_movemask_ps(_mm256_cmp_ps(square, _mm256_mul_ps(reach, reach), _CMP_LT_OQ)));
#else
    std::uint32_t mask = 0;
    for (std::uint32_t l = 0; l < kAtATime; ++l) {
      float dx = x_[i] - x_[others[l]];
      float dy = y_[i] - y_[others[l]];
      dx -= period_[0] * std::rint(dx * per_[0]);
      dy -= period_[1] * std::rint(dy * per_[1]);
      const float reach = reach_ + (equal_ ? 0 : radius_[i] + radius_[others[l]]);
      mask |= dx * dx + dy * dy < reach * reach ? 1U << l : 0U;
    }
    return mask;
#endif
  }

  std::vector<float> x_;
  std::vector<float> y_;
  std::vector<float> radius_;
  std::array<float, 2> period_{};
  std::array<float, 2> per_{};
  float reach_ = 0;  ///< with the radii, where these are equal
  bool wraps_ = false;
  bool equal_ = false;
};

}  // namespace carom::event
