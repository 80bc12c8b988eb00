#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "carom/vector.hpp"

namespace carom::scene {

/// A grid of small cells over the places that are drawn for disks of one radius: a cell is blocked
/// when a disk anywhere in it would overlap one that is there.  One bit tells this of most places
/// in a dense fill, where a search among the disks takes many accesses to memory.
///
/// Holds: never blocks a place that is free; what it does not block may be taken.  Where a grid
/// does not pay, or rounding could count, there are no cells.
class BlockedCells {
 public:
  /// For `count` disks of `radius` with their centres from `lower` to `upper`; no coordinate is
  /// larger than `farthest`.
  BlockedCells(const Vec2& lower, const Vec2& upper, double radius, std::size_t count,
               double farthest);

  /// A disk of this radius is there now.
  void insert(const Vec2& position, double radius);
  /// Of a place from `lower` to `upper`.
  [[nodiscard]] bool blocked(const Vec2& place) const {
    if (columns_ == 0) return false;
    const std::size_t cell = cell_at(place);
    return ((bits_[cell / 64] >> (cell % 64)) & 1U) != 0;
  }
  /// What `blocked` reads, ahead.
  void fetch(const Vec2& place) const {
    if (columns_ > 0) __builtin_prefetch(&bits_[cell_at(place) / 64]);
  }

 private:
  [[nodiscard]] std::size_t cell_at(const Vec2& place) const {
    const Vec2 from_lower = place - lower_;
    const std::size_t column =
        std::min(static_cast<std::size_t>(from_lower.x() * per_side_), columns_ - 1);
    const std::size_t row =
        std::min(static_cast<std::size_t>(from_lower.y() * per_side_), rows_ - 1);
    return row * columns_ + column;
  }
  /// Sets the bits of cells of a row.
  void block(std::size_t first, std::size_t last);

  Vec2 lower_;
  double radius_;
  double per_side_ = 0;      // cells to a length
  std::size_t columns_ = 0;  // 0: there are no cells
  std::size_t rows_ = 0;
  std::vector<std::uint64_t> bits_;
};

}  // namespace carom::scene
