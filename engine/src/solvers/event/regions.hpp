#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "numbers/scalar.hpp"
#include "solvers/event/plot.hpp"
#include "state/domain.hpp"

namespace carom::event {

/// The plane cut into regions, columns of rows, with about equally many balls in each.
///
/// Holds: every point is in one region.
class Regions {
 public:
  Regions(const Domain& domain, std::size_t regions, const std::vector<Vec<double>>& places);

  [[nodiscard]] std::size_t size() const { return regions_.size(); }
  /// The region of a place in the box.
  [[nodiscard]] std::size_t of(const Vec<double>& at) const;
  /// How far a place is outside a region, along the axis on which it is farther; negative: how deep
  /// inside, from the nearest region beside it.
  [[nodiscard]] double outside(std::size_t region, const Vec<double>& at) const;
  /// The region and a rim of this width.
  [[nodiscard]] Plot plot(std::size_t region, double rim) const;
  /// The shorter side of the smallest one.
  [[nodiscard]] double narrowest() const;

 private:
  struct Region {
    std::array<double, 2> lower, upper;
  };
  [[nodiscard]] bool whole(const Region& region, std::size_t axis) const;

  Domain domain_;
  std::vector<Region> regions_;
  std::vector<double> columns_;            // where each column but the first begins
  std::vector<std::vector<double>> rows_;  // of each column, likewise
};

}  // namespace carom::event
