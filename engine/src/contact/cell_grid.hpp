#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/pair_list.hpp"
#include "state/domain.hpp"

namespace carom {

/// The balls sorted into square cells, so that balls near each other are found without trying all.
///
/// Balls beyond an open side count as being in the outermost cells.
/// Threads: `sort` by one thread; `neighbours` by any number afterwards.
class CellGrid {
 public:
  /// Sorts the balls into cells at least `cell` wide.
  void sort(const Balls& balls, const Domain& domain, double cell);

  /// Adds to `pairs` those of balls [begin, end) with a higher ball whose distance is less than the
  /// sum of their radii and `skin`, in order.  REQUIRES: no such distance is above the cell's
  /// width.
  void neighbours(const Balls& balls, const Domain& domain, std::size_t begin, std::size_t end,
                  double skin, PairList& pairs) const;

 private:
  struct Entry {
    double x, y, radius;
    std::int32_t ball;
    bool fixed;
  };

  [[nodiscard]] std::size_t cell_of(std::size_t axis, double x) const;

  std::array<std::size_t, 2> cells_{1, 1};
  std::array<double, 2> origin_{0, 0};
  std::array<double, 2> per_length_{0, 0};  // cells per unit of length
  std::vector<std::uint32_t> starts_;       // by cell, row by row; one more at the end
  std::vector<std::uint32_t> cell_;         // by ball
  std::vector<Entry> entries_;
};

}  // namespace carom
