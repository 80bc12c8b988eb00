#include "solvers/event/groups/region_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace carom::event {

std::uint32_t RegionPairs::along(const Level& level, std::size_t axis, double x) const {
  if (domain_.period[axis] > 0) x = domain_.wrapped(axis, x);
  const double cells = (x - domain_.lower[axis]) * level.per_length[axis];
  return static_cast<std::uint32_t>(std::clamp(cells, 0.0, level.count[axis] - 1.0));
}

void RegionPairs::fill(Level& level, double size, const std::vector<Bounds>& regions) {
  const double most = 2 * std::sqrt(static_cast<double>(level.balls.size())) + 1;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double length = domain_.upper[axis] - domain_.lower[axis];
    level.count[axis] = static_cast<std::uint32_t>(std::clamp(length / size, 1.0, most));
    level.per_length[axis] = level.count[axis] / length;
  }
  level.starts.assign(std::size_t{level.count[0]} * level.count[1] + 1, 0);
  const auto cell_of = [&](std::uint32_t i) {
    return along(level, 1, regions[i].centre[1]) * level.count[0] +
           along(level, 0, regions[i].centre[0]);
  };
  for (const std::uint32_t i : level.balls) ++level.starts[cell_of(i) + 1];
  for (std::size_t c = 1; c < level.starts.size(); ++c) level.starts[c] += level.starts[c - 1];
  std::vector<std::uint32_t> at(level.starts.begin(), level.starts.end() - 1);
  std::vector<std::uint32_t> sorted(level.balls.size());
  for (const std::uint32_t i : level.balls) sorted[at[cell_of(i)]++] = i;
  level.balls = std::move(sorted);
}

// A cell is no narrower than the two regions and radii of two balls of this level, or of one and a
// smaller one: what is near is in the cell or in those around it.
template <class Visit>
void RegionPairs::each_near(const Level& level, const Bounds& region, Visit visit) const {
  std::array<std::array<std::uint32_t, 3>, 2> at{};
  std::array<std::size_t, 2> many{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::uint32_t count = level.count[axis];
    const std::uint32_t middle = along(level, axis, region.centre[axis]);
    const bool round = domain_.period[axis] > 0 && count >= 3;
    at[axis][many[axis]++] = middle;
    if (middle > 0 || round) at[axis][many[axis]++] = (middle + count - 1) % count;
    if (middle + 1 < count || round) at[axis][many[axis]++] = (middle + 1) % count;
  }
  for (std::size_t row = 0; row < many[1]; ++row) {
    for (std::size_t column = 0; column < many[0]; ++column) {
      const std::size_t cell = std::size_t{at[1][row]} * level.count[0] + at[0][column];
      for (std::uint32_t k = level.starts[cell]; k < level.starts[cell + 1]; ++k) {
        visit(level.balls[k]);
      }
    }
  }
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
  for (std::uint32_t l = 0; l < levels; ++l) {
    if (!levels_[l].balls.empty()) fill(levels_[l], 2 * largest[l] * (1 + 0x1p-20), regions);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t l = level_of_[i]; l < levels; ++l) {
      if (levels_[l].balls.empty()) continue;
      each_near(levels_[l], regions[i], [&](std::uint32_t j) {
        if (l == level_of_[i] && j <= i) return;  // it is found from the other
        if (fixed[i] != 0 && fixed[j] != 0) return;
        if (!regions[i].near(regions[j], (radii[i] + radii[j]) * wider, domain_.period)) return;
        pairs_.push_back(fixed[i] != 0 ? RegionPair{j, i} : RegionPair{i, j});
      });
    }
  }
}

}  // namespace carom::event
