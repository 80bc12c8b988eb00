#include "contact/cell_grid.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

std::size_t CellGrid::cell_of(std::size_t axis, double x) const {
  const double place = (x - origin_[axis]) * per_length_[axis];
  if (!(place > 0)) return 0;
  const auto last = cells_[axis] - 1;
  return place < static_cast<double>(last) ? static_cast<std::size_t>(place) : last;
}

void CellGrid::sort(const Balls& balls, const Domain& domain, double cell) {
  const std::size_t n = balls.size();
  const std::array<double, 2> size{domain.upper[0] - domain.lower[0],
                                   domain.upper[1] - domain.lower[1]};
  // More cells than balls would only cost memory.
  const double width = std::max(cell, std::sqrt(size[0] * size[1] / static_cast<double>(n + 1)));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double count = std::floor(size[axis] / width);
    cells_[axis] = static_cast<std::size_t>(std::clamp(count, 1.0, static_cast<double>(n + 1)));
    // Around a periodic axis of two cells the neighbours on both sides are the same cell.
    if (domain.period[axis] > 0 && cells_[axis] < 3) cells_[axis] = 1;
    origin_[axis] = domain.lower[axis];
    per_length_[axis] = static_cast<double>(cells_[axis]) / size[axis];
  }

  starts_.assign(cells_[0] * cells_[1] + 1, 0);
  cell_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 at = balls.at(i);
    cell_[i] = static_cast<std::uint32_t>(cell_of(1, at.y()) * cells_[0] + cell_of(0, at.x()));
    ++starts_[cell_[i] + 1];
  }
  for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
  entries_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Index k = Balls::index(i);
    entries_[starts_[cell_[i]]++] = {balls.position[0][k], balls.position[1][k], balls.radius[k],
                                     static_cast<std::int32_t>(i), balls.fixed(i)};
  }
  for (std::size_t c = starts_.size() - 1; c > 0; --c) starts_[c] = starts_[c - 1];
  starts_[0] = 0;
}

void CellGrid::neighbours(const Balls& balls, const Domain& domain, std::size_t begin,
                          std::size_t end, double skin, PairList& pairs) const {
  const std::size_t columns = cells_[0];
  const std::size_t rows = cells_[1];
  for (std::size_t i = begin; i < end; ++i) {
    const auto ball = static_cast<std::int32_t>(i);
    const Vec2 at = balls.at(i);
    const double radius = balls.radius[Balls::index(i)];
    const bool fixed = balls.fixed(i);
    const std::size_t first_of_ball = pairs.size();
    const auto look = [&](std::size_t row, std::size_t from, std::size_t to) {
      const std::uint32_t last = starts_[row * columns + to];
      for (std::uint32_t e = starts_[row * columns + from]; e < last; ++e) {
        const Entry& other = entries_[e];
        const double dx = nearest_image(other.x - at.x(), domain.period[0]);
        const double dy = nearest_image(other.y - at.y(), domain.period[1]);
        const double reach = radius + other.radius;
        if (other.ball <= ball || dx * dx + dy * dy >= (reach + skin) * (reach + skin)) continue;
        if (!(fixed && other.fixed)) pairs.add(i, static_cast<std::size_t>(other.ball), reach);
      }
    };
    const std::size_t column = cell_[i] % columns;
    const std::size_t row = cell_[i] / columns;
    const bool round_x = domain.period[0] > 0 && columns > 1;
    const bool round_y = domain.period[1] > 0 && rows > 1;
    for (int step = -1; step <= 1; ++step) {
      if (rows == 1 && step != 0) continue;
      std::size_t r = row + static_cast<std::size_t>(step);  // -1 becomes huge on purpose
      if (r >= rows) {
        if (!round_y) continue;
        r = step < 0 ? rows - 1 : 0;
      }
      const std::size_t from = column > 0 ? column - 1 : 0;
      const std::size_t to = std::min(column + 2, columns);
      look(r, from, to);
      if (round_x && column == 0) look(r, columns - 1, columns);
      if (round_x && column + 1 == columns) look(r, 0, 1);
    }
    // In order of the second ball: insertion, since there are few.
    for (std::size_t k = first_of_ball + 1; k < pairs.size(); ++k) {
      for (std::size_t m = k; m > first_of_ball && pairs.second[m] < pairs.second[m - 1]; --m) {
        std::swap(pairs.second[m], pairs.second[m - 1]);
        std::swap(pairs.reach[m], pairs.reach[m - 1]);
      }
    }
  }
}

}  // namespace carom
