#include "fill/disk_grid.hpp"

#include <algorithm>
#include <cmath>

#include "carom/shorter_way.hpp"

namespace carom::scene {

namespace {

std::int64_t to_cell(double index) {
  constexpr double kFarthest = 0x1p60;
  return static_cast<std::int64_t>(std::floor(std::clamp(index, -kFarthest, kFarthest)));
}

/// So much wider than its disks is a cell, that rounding moves no disk beyond the next cell.
constexpr double kWider = 1 + 0x1p-10;
/// More do not fit into the nearest memory.
constexpr std::size_t kFillsCache = 1000;

std::int64_t wrapped(std::int64_t index, std::int64_t count) {
  const std::int64_t rest = index % count;
  return rest < 0 ? rest + count : rest;
}

}  // namespace

double overlap_depth(const Box& box, const Vec2& a, double radius_a, const Vec2& b,
                     double radius_b) {
  const Vec2 r = shorter_way(b - a, box);
  const double s = radius_a + radius_b;
  if (std::abs(r.x()) >= s || std::abs(r.y()) >= s) return 0;
  const double c = std::fma(r.x(), r.x(), std::fma(r.y(), r.y(), -s * s));
  if (c >= 0) return 0;
  // s - |r| = (s^2 - r^2) / (s + |r|): no cancellation where the two nearly touch.
  const double depth = -c / (s + std::sqrt(r.squaredNorm()));
  double coordinates =
      (std::abs(a.x()) + std::abs(a.y())) + (std::abs(b.x()) + std::abs(b.y())) + s;
  for (int axis = 0; axis < 2; ++axis) {
    if (box.periodic[static_cast<std::size_t>(axis)]) coordinates += box.size()[axis];
  }
  return depth > 0x1p-51 * coordinates ? depth : 0;
}

void DiskGrid::set_width(Level& level, double width) const {
  level.per_length = 1 / width;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!box_.periodic[axis]) continue;
    const double size = box_.size()[axis];
    level.around[axis] = std::max<std::int64_t>(1, to_cell(size * level.per_length));
  }
}

DiskGrid::Cell DiskGrid::cell_of(const Level& level, const Vec2& position) const {
  Cell index{0, 0};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto k = axis;
    const double from_lower = position[k] - box_.lower()[k];
    const std::int64_t cells = level.around[axis];
    if (cells == 0) {
      index[axis] = to_cell(from_lower * level.per_length);
    } else {
      // The cells of a periodic axis are a little wider, so that a whole number goes around.
      const double turn = from_lower / box_.size()[k];
      index[axis] = wrapped(to_cell((turn - std::floor(turn)) * static_cast<double>(cells)), cells);
    }
  }
  return index;
}

std::size_t DiskGrid::bucket(const Level& level, const Cell& cell) {
  // Cells beside each other in a row have buckets beside each other in memory.
  std::uint64_t h = static_cast<std::uint64_t>(cell[1]) * 0xC2B2AE3D27D4EB4FU;
  h ^= h >> 32;
  return static_cast<std::size_t>(h + static_cast<std::uint64_t>(cell[0])) &
         (level.buckets.size() - 1);
}

void DiskGrid::put_into_bucket(Level& level, std::uint32_t number) {
  std::uint32_t& head = level.buckets[bucket(level, disks_[number].cell)];
  disks_[number].next = head;
  head = number;
}

void DiskGrid::insert(const Vec2& position, double radius) {
  const int exponent = std::ilogb(radius);
  auto level = std::find_if(levels_.begin(), levels_.end(),
                            [&](const Level& known) { return known.exponent == exponent; });
  if (level == levels_.end()) {
    levels_.emplace_back();
    level = levels_.end() - 1;
    level->exponent = exponent;
    level->largest = radius;
    set_width(*level, 2 * radius * kWider);
    level->buckets.assign(64, kNone);
  } else if (radius > level->largest) {
    // Once the first disk proves not to be the largest, the cells take all that can come.
    level->largest = radius;
    if (!level->widest) {
      level->widest = true;
      set_width(*level, std::ldexp(kWider, exponent + 2));
      sort_anew(*level, level->buckets.size());
    }
  }
  const auto number = static_cast<std::uint32_t>(disks_.size());
  disks_.push_back({position, radius, cell_of(*level, position), kNone});
  put_into_bucket(*level, number);
  // Most buckets are empty, so that few disks of other cells are looked at.
  if (++level->count * 4 > level->buckets.size()) sort_anew(*level, level->buckets.size() * 4);
}

void DiskGrid::sort_anew(Level& level, std::size_t buckets) {
  level.buckets.assign(buckets, kNone);
  for (std::uint32_t i = 0; i < disks_.size(); ++i) {
    if (std::ilogb(disks_[i].radius) != level.exponent) continue;
    disks_[i].cell = cell_of(level, disks_[i].position);
    put_into_bucket(level, i);
  }
}

template <class Found>
void DiskGrid::visit(const Vec2& position, double radius, Found found) const {
  const auto overlaps = [&](std::uint32_t i) {
    return overlap_depth(box_, position, radius, disks_[i].position, disks_[i].radius) > 0;
  };
  for (const Level& level : levels_) {
    // As many cells to each side as the two disks can reach over.
    const std::int64_t reach = 1 + to_cell((radius + level.largest) * level.per_length);
    if (reach > 1000 ||
        static_cast<std::size_t>((2 * reach + 1) * (2 * reach + 1)) > 4 * level.count + 9) {
      for (std::uint32_t i = 0; i < disks_.size(); ++i) {
        if (std::ilogb(disks_[i].radius) == level.exponent && overlaps(i) && found(i)) return;
      }
      continue;
    }
    const auto [cell_x, cell_y] = cell_of(level, position);
    const auto [around_x, around_y] = level.around;
    // Around a periodic axis no cell is visited twice.
    const std::int64_t last_x =
        around_x == 0 ? cell_x + reach : std::min(cell_x + reach, cell_x - reach + around_x - 1);
    const std::int64_t last_y =
        around_y == 0 ? cell_y + reach : std::min(cell_y + reach, cell_y - reach + around_y - 1);
    const auto for_each_cell = [&](const auto& look) {
      for (std::int64_t y = cell_y - reach; y <= last_y; ++y) {
        const std::int64_t at_y = around_y == 0 ? y : wrapped(y, around_y);
        for (std::int64_t x = cell_x - reach; x <= last_x; ++x) {
          const Cell at{around_x == 0 ? x : wrapped(x, around_x), at_y};
          if (look(at, level.buckets[bucket(level, at)])) return true;
        }
      }
      return false;
    };
    // Disks of many are far from each other in memory: all are on their way at once.
    if (disks_.size() > kFillsCache) {
      for_each_cell([&](const Cell&, std::uint32_t first) {
        if (first != kNone) __builtin_prefetch(&disks_[first]);
        return false;
      });
    }
    const bool done = for_each_cell([&](const Cell& at, std::uint32_t first) {
      for (std::uint32_t i = first; i != kNone; i = disks_[i].next) {
        // Other cells may share the bucket.  (Compared one by one: == of arrays is a call.)
        const bool here = disks_[i].cell[0] == at[0] && disks_[i].cell[1] == at[1];
        if (here && overlaps(i) && found(i)) return true;
      }
      return false;
    });
    if (done) return;
  }
}

std::vector<std::size_t> DiskGrid::overlapping(const Vec2& position, double radius,
                                               std::size_t at_most) const {
  std::vector<std::size_t> numbers;
  visit(position, radius, [&](std::uint32_t i) {
    numbers.push_back(i);
    return numbers.size() >= at_most;
  });
  return numbers;
}

bool DiskGrid::is_free(const Vec2& position, double radius) const {
  bool free = true;
  visit(position, radius, [&](std::uint32_t) {
    free = false;
    return true;
  });
  return free;
}

}  // namespace carom::scene
