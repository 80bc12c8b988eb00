#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/disjoint_sets.hpp"
#include "contact/pair_list.hpp"

namespace carom {

/// Touching pairs sorted into groups: two pairs that share a ball are in the same group.
///
/// Holds: groups in the order of their first pair; within a group the pairs keep their order.
class Groups {
 public:
  /// Sorts `pairs` into groups; `balls` is the number of balls there are.
  void sort(std::span<const Pair> pairs, std::size_t balls);

  [[nodiscard]] std::size_t count() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  [[nodiscard]] std::size_t pairs() const { return pairs_.size(); }
  [[nodiscard]] std::size_t largest() const { return largest_; }
  [[nodiscard]] std::span<const Pair> group(std::size_t g) const {
    return std::span(pairs_).subspan(starts_[g], starts_[g + 1] - starts_[g]);
  }

 private:
  DisjointSets sets_;                    // of the touching balls
  std::vector<std::uint32_t> group_of_;  // by root ball
  std::vector<std::uint32_t> group_;     // by pair
  std::vector<std::size_t> starts_;
  std::vector<Pair> pairs_;
  std::size_t largest_ = 0;
};

}  // namespace carom
