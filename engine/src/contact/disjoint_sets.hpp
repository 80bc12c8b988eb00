#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace carom {

/// Numbers in sets that only ever merge.  Which number stands for a set does not depend on the
/// order of the merges: it is the lowest.
class DisjointSets {
 public:
  /// Each number below n in a set of its own.
  void reset(std::size_t n) {
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), 0U);
    next_ = parent_;
  }
  /// Takes numbers below n.
  /// REQUIRES: of those that are asked for, each is put in a set of its own first.
  void make_room(std::size_t n) {
    parent_.resize(n);
    next_.resize(n);
  }
  void isolate(std::uint32_t i) { parent_[i] = next_[i] = i; }
  [[nodiscard]] std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// The same without making later searches shorter: any number of threads may ask at once.
  [[nodiscard]] std::uint32_t look_up(std::uint32_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  /// Whether they were in different sets.
  bool merge(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    if (i == j) return false;
    if (j < i) std::swap(i, j);
    parent_[j] = i;
    std::swap(next_[i], next_[j]);  // two rings become one
    return true;
  }
  [[nodiscard]] bool alone(std::uint32_t i) const { return next_[i] == i; }
  /// All numbers of the set of i, beginning with i.
  /// REQUIRES: `visit` merges no sets.
  template <class Visit>
  void each(std::uint32_t i, Visit visit) const {
    std::uint32_t k = i;
    do {
      visit(k);
      k = next_[k];
    } while (k != i);
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> next_;  // the members of a set in a ring
};

}  // namespace carom
