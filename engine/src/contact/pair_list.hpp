#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "state/balls.hpp"

namespace carom {

/// Two balls by their numbers, the lower one first.
struct Pair {
  std::uint32_t first = 0;
  std::uint32_t second = 0;

  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misreads what the compiler writes here
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

/// Pairs worth a look, column by column.
/// Holds: `reach` is the sum of the two radii; beyond `count` the columns are spare room.
struct PairList {
  static constexpr std::size_t kBytesOfPair = 2 * sizeof(std::int32_t) + sizeof(double);

  std::vector<std::int32_t> first;
  std::vector<std::int32_t> second;
  std::vector<double> reach;
  std::size_t count = 0;

  void clear() { count = 0; }
  /// Makes room for some pairs more.
  void make_room(std::size_t pairs) {
    if (count + pairs <= reach.size()) return;
    const std::size_t size = 2 * (count + pairs);
    first.resize(size);
    second.resize(size);
    reach.resize(size);
  }
  /// Writes a pair into the room behind the last one; it counts if `taken`.
  void put(std::int32_t i, std::int32_t j, double sum_of_radii, bool taken) {
    first[count] = i;
    second[count] = j;
    reach[count] = sum_of_radii;
    count += taken ? 1 : 0;
  }
};

/// All unique pairs of which at least one ball moves.
PairList all_pairs(const Balls& balls);

}  // namespace carom
