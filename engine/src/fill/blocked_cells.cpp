#include "fill/blocked_cells.hpp"

#include <algorithm>
#include <cmath>

namespace carom::scene {
namespace {

constexpr std::size_t kMany = 1000;      // of fewer disks a search is quick
constexpr double kCellsPerDisk = 64;     // one bit each
constexpr double kFar = 0x1p30;          // radii: what touches is judged to 2^-51 of a coordinate
constexpr double kSurely = 1 - 0x1p-10;  // of the sum of radii: more than rounding can move

}  // namespace

BlockedCells::BlockedCells(const Vec2& lower, const Vec2& upper, double radius, std::size_t count,
                           double farthest)
    : lower_(lower), radius_(radius) {
  const Vec2 size = upper - lower;
  const double cells = kCellsPerDisk * static_cast<double>(count);
  side_ = std::max(radius / 2, std::sqrt(size.x() * size.y() / cells));
  // Wider cells are never blocked as a whole; longer rows would be more than their area says.
  const double columns = std::floor(size.x() / side_) + 1;
  const double rows = std::floor(size.y() / side_) + 1;
  if (count < kMany || side_ > radius || !(farthest < kFar * radius) ||
      columns * rows > 2 * cells) {
    return;
  }
  columns_ = static_cast<std::size_t>(columns);
  rows_ = static_cast<std::size_t>(rows);
  bits_.assign((columns_ * rows_ + 63) / 64, 0);
}

void BlockedCells::insert(const Vec2& position, double radius) {
  if (columns_ == 0) return;
  const double reach = (radius_ + radius) * kSurely / side_;
  const double x = (position.x() - lower_.x()) / side_;
  const double y = (position.y() - lower_.y()) / side_;
  const auto last_row = static_cast<double>(rows_) - 1;
  const auto last_column = static_cast<double>(columns_) - 1;
  const double first = std::max(std::ceil(y - reach), 0.0);
  const double last = std::min(std::floor(y + reach) - 1, last_row);
  for (double row = first; row <= last; ++row) {
    const double away = std::max(std::abs(row - y), std::abs(row + 1 - y));
    const double half = std::sqrt(std::max(reach * reach - away * away, 0.0));
    const double from = std::max(std::ceil(x - half), 0.0);
    const double to = std::min(std::floor(x + half) - 1, last_column);
    for (double column = from; column <= to; ++column) {
      const std::size_t cell =
          static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column);
      bits_[cell / 64] |= std::uint64_t{1} << (cell % 64);
    }
  }
}

bool BlockedCells::blocked(const Vec2& place) const {
  if (columns_ == 0) return false;
  const Vec2 from_lower = place - lower_;
  const std::size_t column =
      std::min(static_cast<std::size_t>(from_lower.x() / side_), columns_ - 1);
  const std::size_t row = std::min(static_cast<std::size_t>(from_lower.y() / side_), rows_ - 1);
  const std::size_t cell = row * columns_ + column;
  return ((bits_[cell / 64] >> (cell % 64)) & 1U) != 0;
}

}  // namespace carom::scene
