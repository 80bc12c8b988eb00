#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/pair_list.hpp"
#include "geometry/cells.hpp"
#include "state/domain.hpp"

namespace carom {

/// The balls sorted into square cells, so that balls near each other are found without trying all.
///
/// Balls beyond an open side count as being in the outermost cells.
/// Threads: `sort` by one thread; `neighbours` by any number afterwards.
class CellGrid {
 public:
  /// Of a ball, and of a cell, of which there are as many at the most.
  static constexpr std::size_t kBytesOfBall =
      3 * sizeof(double) + 3 * sizeof(std::uint32_t) + sizeof(std::uint8_t);

  /// Sorts the balls into cells at least `cell` wide.
  void sort(const Balls& balls, const Domain& domain, double cell);

  [[nodiscard]] std::size_t cells() const { return cells_.size(); }

  /// Adds to `pairs` those found from the cells [begin, end): two balls whose distance is less than
  /// the sum of their radii and `skin`, one of which moves.  Every pair is found from one cell.
  /// REQUIRES: no such distance is above the cell's width.
  void neighbours(const Domain& domain, std::size_t begin, std::size_t end, double skin,
                  PairList& pairs) const;

 private:
  template <bool kPeriodic>
  void search(const Domain& domain, std::size_t begin, std::size_t end, double skin,
              PairList& pairs) const;

  Cells cells_;
  ByCell order_;
  // The balls, cell by cell.
  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> radius_;
  std::vector<std::int32_t> ball_;
  std::vector<std::uint8_t> moves_;
};

}  // namespace carom
