#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/cells.hpp"
#include "state/domain.hpp"

namespace carom::event {

/// An axis-parallel box, by its centre and half its sides.
struct Bounds {
  std::array<double, 2> centre{0, 0};
  std::array<double, 2> half{0, 0};

  /// Whether the gaps between the two boxes, the shorter way round periodic axes, are within
  /// `reach` along both axes.
  [[nodiscard]] bool near(const Bounds& other, double reach,
                          const std::array<double, 2>& periods) const {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      double off = other.centre[axis] - centre[axis];
      if (periods[axis] > 0) off -= periods[axis] * std::rint(off / periods[axis]);
      if (!(std::abs(off) <= half[axis] + other.half[axis] + reach)) return false;
    }
    return true;
  }
  [[nodiscard]] bool contains(const Bounds& other, const std::array<double, 2>& periods) const {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      double off = other.centre[axis] - centre[axis];
      if (periods[axis] > 0) off -= periods[axis] * std::rint(off / periods[axis]);
      if (!(std::abs(off) + other.half[axis] <= half[axis])) return false;
    }
    return true;
  }
};

/// Two balls by their numbers; the first can move.
struct RegionPair {
  std::uint32_t first;
  std::uint32_t second;
};

/// The unique pairs of balls that may come to touch while each stays in its region.
///
/// Cost: grids of cells, one for each power of two of sizes, so that one large ball among many
/// small ones looks at those near it and they at it.
class RegionPairs {
 public:
  explicit RegionPairs(const Domain& domain) : domain_(domain) {}

  /// The pairs of balls whose regions come within their radii, times `wider`, of each other; of two
  /// that are fixed there is none.
  void build(const std::vector<Bounds>& regions, const std::vector<double>& radii,
             const std::vector<char>& fixed, double wider);
  [[nodiscard]] const std::vector<RegionPair>& pairs() const { return pairs_; }

 private:
  struct Level {
    Cells cells;
    ByCell order;
    std::vector<std::uint32_t> balls;  // cell by cell
  };

  void sort(Level& level, double size, const std::vector<Bounds>& regions) const;
  /// Column and row of the middle of a region.
  [[nodiscard]] std::array<Cells::Number, 2> place(const Level& level, const Bounds& region) const;

  Domain domain_;
  std::vector<Level> levels_;
  std::vector<std::uint32_t> level_of_;
  std::vector<RegionPair> pairs_;
};

}  // namespace carom::event
