#include "fill/equal_disks.hpp"

#include <algorithm>
#include <cmath>

#include "fill/disk_grid.hpp"

namespace carom::scene {
namespace {

/// So much wider than its disks is a cell, that rounding moves no disk beyond the next cell.
constexpr double kCellOfDisks = 1 + 0x1p-9;

}  // namespace

// Where the region does not go all around a periodic axis, two disks in it are no nearer to each
// other the other way round than they are wide.
EqualDisks::EqualDisks(const Box& box, const Region& centres, double radius, std::size_t count)
    : box_(box), radius_(radius) {
  const Vec2 size = centres.upper - centres.lower;
  const double share = std::sqrt(size.x() * size.y() / static_cast<double>(count));
  const double side = std::max(2 * radius * kCellOfDisks, share);
  const double most = static_cast<double>(count) + 8;  // of a long and narrow region
  for (std::size_t axis = 0; axis < 2; ++axis) {
    cells_.divide(axis, centres.lower[axis], size[axis], std::min(size[axis] / side, most),
                  centres.around[axis]);
    same_image_[axis] = box.periodic[axis] ? 0.499 * box.size()[axis] : HUGE_VAL;
  }
  heads_.assign(cells_.size(), kNone);
  disks_.reserve(count);
}

void EqualDisks::insert(const Vec2& place) {
  std::uint32_t& head = heads_[cells_.at(place.x(), place.y())];
  disks_.push_back({place.x(), place.y(), head});
  head = static_cast<std::uint32_t>(disks_.size()) - 1;
}

bool EqualDisks::is_free(const Vec2& place) const {
  const double reach = 2 * radius_;
  const double far = reach * reach * kCellOfDisks;
  const Cells::Near columns = cells_.near(0, cells_.along(0, place.x()));
  for (const Cells::Number row : cells_.near(1, cells_.along(1, place.y()))) {
    for (const Cells::Number column : columns) {
      std::uint32_t k = heads_[cells_.number(column, row)];
      while (k != kNone) {
        const Disk& disk = disks_[k];
        const double x = std::abs(place.x() - disk.x);
        const double y = std::abs(place.y() - disk.y);
        const bool apart = x < same_image_[0] && y < same_image_[1] && x * x + y * y > far;
        if (!apart && overlap_depth(box_, place, radius_, {disk.x, disk.y}, radius_) > 0) {
          return false;
        }
        k = disk.next;
      }
    }
  }
  return true;
}

void EqualDisks::fetch_cells(const Vec2& place) const {
  const Cells::Number column = cells_.along(0, place.x());
  for (const Cells::Number row : cells_.near(1, cells_.along(1, place.y()))) {
    __builtin_prefetch(&heads_[cells_.number(column, row)]);
  }
}

void EqualDisks::fetch_first(const Vec2& place) const {
  each_head(place, [this](std::uint32_t k) { __builtin_prefetch(&disks_[k]); });
}

void EqualDisks::fetch_second(const Vec2& place) const {
  each_head(place, [this](std::uint32_t k) {
    const std::uint32_t second = disks_[k].next;
    if (second != kNone) __builtin_prefetch(&disks_[second]);
  });
}

}  // namespace carom::scene
