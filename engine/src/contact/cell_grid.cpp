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
  x_.resize(n);
  y_.resize(n);
  radius_.resize(n);
  ball_.resize(n);
  moves_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = i;
    const std::size_t e = starts_[cell_[i]]++;
    x_[e] = balls.position[0][k];
    y_[e] = balls.position[1][k];
    radius_[e] = balls.radius[k];
    ball_[e] = static_cast<std::int32_t>(i);
    moves_[e] = balls.fixed(i) ? 0 : 1;
  }
  for (std::size_t c = starts_.size() - 1; c > 0; --c) starts_[c] = starts_[c - 1];
  starts_[0] = 0;
}

void CellGrid::neighbours(const Domain& domain, std::size_t begin, std::size_t end, double skin,
                          PairList& pairs) const {
  if (domain.period[0] > 0 || domain.period[1] > 0) {
    search<true>(domain, begin, end, skin, pairs);
  } else {
    search<false>(domain, begin, end, skin, pairs);
  }
}

template <bool kPeriodic>
void CellGrid::search(const Domain& domain, std::size_t begin, std::size_t end, double skin,
                      PairList& pairs) const {
  const std::size_t columns = cells_[0];
  const std::size_t rows = cells_[1];
  const bool round_x = domain.period[0] > 0 && columns > 1;
  const bool round_y = domain.period[1] > 0 && rows > 1;
  // Entry e against the entries [from, to).  Whether a pair is taken is not a branch: half of them
  // are, in no order that could be foreseen.
  const auto look = [&](std::size_t e, std::size_t from, std::size_t to) {
    pairs.make_room(to - from);
    for (std::size_t f = from; f < to; ++f) {
      double dx = x_[f] - x_[e];
      double dy = y_[f] - y_[e];
      if constexpr (kPeriodic) {
        dx = nearest_image(dx, domain.period[0]);
        dy = nearest_image(dy, domain.period[1]);
      }
      const double reach = radius_[e] + radius_[f];
      const double far = reach + skin;
      const bool near = dx * dx + dy * dy < far * far;
      pairs.put(std::min(ball_[e], ball_[f]), std::max(ball_[e], ball_[f]), reach,
                near && (moves_[e] | moves_[f]) != 0);
    }
  };
  // Each cell looks at itself, the cell to the right and the three above.
  for (std::size_t cell = begin; cell < end; ++cell) {
    const std::size_t column = cell % columns;
    const std::size_t row = cell / columns;
    const bool last_column = column + 1 == columns;
    const std::size_t right = starts_[cell + (last_column ? 1 : 2)];
    const std::size_t above = row + 1 < rows ? row + 1 : 0;
    const bool has_above = row + 1 < rows || round_y;
    const std::size_t left_of = column > 0 ? column - 1 : 0;
    const std::size_t right_of = last_column ? column : column + 1;
    for (std::size_t e = starts_[cell]; e < starts_[cell + 1]; ++e) {
      look(e, e + 1, right);
      if (round_x && last_column) look(e, starts_[row * columns], starts_[row * columns + 1]);
      if (!has_above) continue;
      look(e, starts_[above * columns + left_of], starts_[above * columns + right_of + 1]);
      if (round_x && last_column) look(e, starts_[above * columns], starts_[above * columns + 1]);
      if (round_x && column == 0) {
        look(e, starts_[above * columns + columns - 1], starts_[above * columns + columns]);
      }
    }
  }
}

}  // namespace carom
