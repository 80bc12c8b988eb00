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
  const double side = std::max(radius / 3, std::sqrt(size.x() * size.y() / cells));
  // Wider cells are never blocked as a whole; longer rows would be more than their area says.
  const double columns = std::floor(size.x() / side) + 1;
  const double rows = std::floor(size.y() / side) + 1;
  if (count < kMany || side > radius || !(farthest < kFar * radius) || columns * rows > 2 * cells) {
    return;
  }
  per_side_ = 1 / side;
  columns_ = static_cast<std::size_t>(columns);
  rows_ = static_cast<std::size_t>(rows);
  bits_.assign((columns_ * rows_ + 63) / 64, 0);
}

void BlockedCells::insert(const Vec2& position, double radius) {
  if (columns_ == 0) return;
  const double reach = (radius_ + radius) * kSurely * per_side_;
  const double x = (position.x() - lower_.x()) * per_side_;
  const double y = (position.y() - lower_.y()) * per_side_;
  const auto last_row = static_cast<double>(rows_) - 1;
  const auto last_column = static_cast<double>(columns_) - 1;
  const double first = std::max(std::ceil(y - reach), 0.0);
  const double last = std::min(std::floor(y + reach) - 1, last_row);
  for (double row = first; row <= last; ++row) {
    const double away = std::max(std::abs(row - y), std::abs(row + 1 - y));
    const double half = std::sqrt(std::max(reach * reach - away * away, 0.0));
    const double from = std::max(std::ceil(x - half), 0.0);
    const double to = std::min(std::floor(x + half) - 1, last_column);
    if (to < from) continue;
    const std::size_t start = static_cast<std::size_t>(row) * columns_;
    block(start + static_cast<std::size_t>(from), start + static_cast<std::size_t>(to));
  }
}

void BlockedCells::block(std::size_t first, std::size_t last) {
  const std::uint64_t from = ~std::uint64_t{0} << (first % 64);
  const std::uint64_t to = ~std::uint64_t{0} >> (63 - last % 64);
  if (first / 64 == last / 64) {
    bits_[first / 64] |= from & to;
    return;
  }
  bits_[first / 64] |= from;
  for (std::size_t word = first / 64 + 1; word < last / 64; ++word) bits_[word] = ~std::uint64_t{0};
  bits_[last / 64] |= to;
}

}  // namespace carom::scene
