#include "solvers/event/groups/region_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace carom::event {

std::array<Cells::Number, 2> RegionPairs::place(const Level& level, const Bounds& region) const {
  std::array<Cells::Number, 2> place{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double x = region.centre[axis];
    place[axis] = level.cells.along(axis, domain_.period[axis] > 0 ? domain_.wrapped(axis, x) : x);
  }
  return place;
}

void RegionPairs::sort(Level& level, double size, const std::vector<Bounds>& regions) const {
  const double most = 2 * std::sqrt(static_cast<double>(level.balls.size())) + 1;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double length = domain_.upper[axis] - domain_.lower[axis];
    level.cells.divide(axis, domain_.lower[axis], length, std::min(length / size, most),
                       domain_.period[axis] > 0);
  }
  const std::vector<std::uint32_t> given = level.balls;
  const auto cell_of = [&](std::size_t k) {
    const auto [column, row] = place(level, regions[given[k]]);
    return level.cells.number(column, row);
  };
  level.order.sort(level.cells.size(), given.size(), cell_of,
                   [&](std::size_t k, std::uint32_t at) { level.balls[at] = given[k]; });
}

void RegionPairs::build(const std::vector<Bounds>& regions, const std::vector<double>& radii,
                        const std::vector<char>& fixed, double wider) {
  pairs_.clear();
  levels_.clear();
  const std::size_t n = regions.size();
  // A ball's size: two of the same size can touch only if their centres are nearer than twice it.
  const auto size = [&](std::size_t i) {
    return std::max(regions[i].half[0], regions[i].half[1]) + radii[i] * wider;
  };
  double least = 0;
  for (std::size_t i = 0; i < n; ++i) least = i == 0 ? size(i) : std::min(least, size(i));
  if (!(least > 0)) return;
  level_of_.resize(n);
  std::uint32_t levels = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double times = size(i) / least;
    const int power = std::isfinite(times) ? std::min(std::ilogb(times), 40) : 40;
    level_of_[i] = static_cast<std::uint32_t>(power);
    levels = std::max(levels, level_of_[i] + 1);
  }
  levels_.resize(levels);
  std::vector<double> largest(levels, 0);
  for (std::size_t i = 0; i < n; ++i) {
    levels_[level_of_[i]].balls.push_back(static_cast<std::uint32_t>(i));
    largest[level_of_[i]] = std::max(largest[level_of_[i]], size(i));
  }
  // A cell is no narrower than the two regions and radii of two balls of its level, or of one and a
  // smaller one: what is near is in the cell or in those around it.
  for (std::uint32_t l = 0; l < levels; ++l) {
    if (!levels_[l].balls.empty()) sort(levels_[l], 2 * largest[l] * (1 + 0x1p-20), regions);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t l = level_of_[i]; l < levels; ++l) {
      const Level& level = levels_[l];
      if (level.balls.empty()) continue;
      const auto look = [&](std::uint32_t j) {
        if (l == level_of_[i] && j <= i) return;  // it is found from the other
        if (fixed[i] != 0 && fixed[j] != 0) return;
        if (!regions[i].near(regions[j], (radii[i] + radii[j]) * wider, domain_.period)) return;
        pairs_.push_back(fixed[i] != 0 ? RegionPair{j, i} : RegionPair{i, j});
      };
      const auto [column, row] = place(level, regions[i]);
      level.cells.each_near(column, row, [&](std::uint32_t cell) {
        for (std::uint32_t k = level.order.begin(cell); k < level.order.end(cell); ++k) {
          look(level.balls[k]);
        }
      });
    }
  }
}

}  // namespace carom::event
