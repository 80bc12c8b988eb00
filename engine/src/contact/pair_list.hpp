#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "state/balls.hpp"

namespace carom {

/// Two balls by their numbers, the lower one first.
struct Pair {
  std::uint32_t first = 0;
  std::uint32_t second = 0;

  friend bool operator==(const Pair&, const Pair&) = default;
};

/// Pairs worth a look, column by column.
/// Holds: sorted by first, then by second ball; `reach` is the sum of the two radii.
struct PairList {
  std::vector<std::int32_t> first;
  std::vector<std::int32_t> second;
  std::vector<double> reach;

  [[nodiscard]] std::size_t size() const { return reach.size(); }
  void clear() {
    first.clear();
    second.clear();
    reach.clear();
  }
  void add(std::size_t i, std::size_t j, double sum_of_radii) {
    first.push_back(static_cast<std::int32_t>(i));
    second.push_back(static_cast<std::int32_t>(j));
    reach.push_back(sum_of_radii);
  }
};

/// All unique pairs of which at least one ball moves.
PairList all_pairs(const Balls& balls);

}  // namespace carom
