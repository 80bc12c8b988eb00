#include "contact/cell_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom {

void CellGrid::sort(const Balls& balls, const Domain& domain, double cell) {
  const std::size_t n = balls.size();
  const std::array<double, 2> size{domain.upper[0] - domain.lower[0],
                                   domain.upper[1] - domain.lower[1]};
  // More cells than balls would only cost memory.
  const double width = std::max(cell, std::sqrt(size[0] * size[1] / static_cast<double>(n + 1)));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const bool wraps = domain.period[axis] > 0;
    double count = std::clamp(size[axis] / width, 1.0, static_cast<double>(n + 1));
    // Around a periodic axis of two cells the neighbours on both sides are the same cell.
    if (wraps && count < 3) count = 1;
    cells_.divide(axis, domain.lower[axis], size[axis], count, wraps);
  }
  x_.resize(n);
  y_.resize(n);
  radius_.resize(n);
  ball_.resize(n);
  moves_.resize(n);
  const auto cell_of = [&](std::size_t i) {
    return cells_.at(balls.position[0][i], balls.position[1][i]);
  };
  order_.sort(cells_.size(), n, cell_of, [&](std::size_t i, std::uint32_t place) {
    x_[place] = balls.position[0][i];
    y_[place] = balls.position[1][i];
    radius_[place] = balls.radius[i];
    ball_[place] = static_cast<std::int32_t>(i);
    moves_[place] = balls.fixed(i) ? 0 : 1;
  });
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
  const std::size_t columns = cells_.count(0);
  const std::size_t rows = cells_.count(1);
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
    const std::size_t right = order_.end(last_column ? cell : cell + 1);
    const std::size_t above = row + 1 < rows ? row + 1 : 0;
    const bool has_above = row + 1 < rows || round_y;
    const std::size_t left_of = column > 0 ? column - 1 : 0;
    const std::size_t right_of = last_column ? column : column + 1;
    for (std::size_t e = order_.begin(cell); e < order_.end(cell); ++e) {
      look(e, e + 1, right);
      if (round_x && last_column) look(e, order_.begin(row * columns), order_.end(row * columns));
      if (!has_above) continue;
      look(e, order_.begin(above * columns + left_of), order_.end(above * columns + right_of));
      if (round_x && last_column)
        look(e, order_.begin(above * columns), order_.end(above * columns));
      if (round_x && column == 0) {
        look(e, order_.begin(above * columns + columns - 1),
             order_.end(above * columns + columns - 1));
      }
    }
  }
}

}  // namespace carom
