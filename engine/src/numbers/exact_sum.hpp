#pragma once

#include <cstddef>
#include <vector>

#include "numbers/scalar.hpp"

namespace carom::event {

/// A sum rounded once, so that the order of its terms cannot be seen in its bits.
/// Holds: the running total as parts that do not overlap, growing in size; their sum is exact.
/// Source: Shewchuk, Discrete Comput. Geom. 18 (1997) 305, grow-expansion.
template <class S>
class ExactSum {
 public:
  void clear() { parts_.clear(); }

  void add(S term) {
    std::size_t kept = 0;
    for (const S& part : parts_) {
      const auto sum = two_sum(term, part);
      if (sum.low != 0) parts_[kept++] = sum.low;
      term = sum.high;
    }
    parts_.resize(kept);
    if (term != 0) parts_.push_back(term);
  }

  /// Terms of which it is the sum, few and exact.
  [[nodiscard]] const std::vector<S>& parts() const { return parts_; }

  S rounded() const {
    if (parts_.empty()) return S(0);
    std::size_t n = parts_.size() - 1;
    S high = parts_[n];
    S low = 0;
    while (n > 0 && low == 0) {
      const auto sum = two_sum(high, parts_[--n]);
      high = sum.high;
      low = sum.low;
    }
    // halfway between two numbers, and what lies below the half decides
    if (n > 0 && low != 0 && ((low < 0) == (parts_[n - 1] < 0))) {
      const S twice = low * 2;
      const S other = high + twice;
      if (other - high == twice) high = other;
    }
    return high;
  }

 private:
  std::vector<S> parts_;
};

}  // namespace carom::event
