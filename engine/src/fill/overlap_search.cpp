#include "fill/overlap_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "fill/disk_grid.hpp"
#include "geometry/cells.hpp"

namespace carom::scene {

namespace {

/// So much wider than the largest ball is a cell, that rounding moves none beyond the next cell.
constexpr double kCellWider = 1 + 0x1p-10;
/// Pairs to look at for each ball: with more a DiskGrid is quicker.
constexpr std::uint64_t kMostPairs = 64;

/// What a search needs of a ball, in the order of the cells.
struct Sorted {
  double x = 0;
  double y = 0;
  double radius = 0;
  bool fixed = false;
};

/// Cells of one size over all balls, as wide as the largest ball or wider.
Cells cells_over(const Box& box, const std::vector<Ball>& balls) {
  Vec2 lower = balls.front().position;
  Vec2 upper = lower;
  double largest = 0;
  for (const Ball& ball : balls) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      lower[axis] = std::min(lower[axis], ball.position[axis]);
      upper[axis] = std::max(upper[axis], ball.position[axis]);
    }
    largest = std::max(largest, ball.radius);
  }
  std::array<double, 2> count{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (box.periodic[axis]) {
      lower[axis] = box.lower()[axis];
      upper[axis] = box.upper()[axis];
    }
    count[axis] =
        std::max(1.0, std::floor((upper[axis] - lower[axis]) / (2 * largest * kCellWider)));
  }
  const double most = 2 * static_cast<double>(balls.size()) + 16;
  while (count[0] * count[1] > most) {
    double& more = count[0] > count[1] ? count[0] : count[1];
    more = std::max(1.0, std::floor(more / 2));
  }
  Cells cells;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    cells.divide(axis, lower[axis], upper[axis] - lower[axis], count[axis], box.periodic[axis]);
  }
  return cells;
}

/// A coordinate in the box of a periodic axis; any other is left.
double in_box(const Box& box, std::size_t axis, double x) {
  if (!box.periodic[axis]) return x;
  const double turn = (x - box.lower()[axis]) / box.size()[axis];
  return box.lower()[axis] + (turn - std::floor(turn)) * box.size()[axis];
}

/// The balls in the order of their cells.
struct SortedBalls {
  ByCell order;
  std::vector<Sorted> balls;

  SortedBalls(const Box& box, const Cells& cells, const std::vector<Ball>& all)
      : balls(all.size()) {
    const auto cell_of = [&](std::size_t i) {
      const Vec2& at = all[i].position;
      return cells.at(in_box(box, 0, at.x()), in_box(box, 1, at.y()));
    };
    order.sort(cells.size(), all.size(), cell_of, [&](std::size_t i, std::uint32_t place) {
      const Ball& ball = all[i];
      balls[place] = {ball.position.x(), ball.position.y(), ball.radius, ball.fixed};
    });
  }

  [[nodiscard]] std::uint64_t pairs(std::size_t cells) const {
    std::uint64_t sum = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const std::uint64_t count = order.end(cell) - order.begin(cell);
      sum += count * count;
    }
    return sum;
  }
};

class Search {
 public:
  explicit Search(const Box& box) : box_(box) {}

  [[nodiscard]] bool overlap(const Sorted& a, const Sorted& b) const {
    if (a.fixed && b.fixed) return false;
    const double reach = a.radius + b.radius;
    // Most are far apart: no need to be exact, but round a periodic axis it is longer.
    if (!box_.periodic[0] && std::abs(a.x - b.x) >= reach) return false;
    if (!box_.periodic[1] && std::abs(a.y - b.y) >= reach) return false;
    return overlap_depth(box_, {a.x, a.y}, a.radius, {b.x, b.y}, b.radius) > 0;
  }

 private:
  const Box& box_;
};

}  // namespace

bool may_overlap(const Box& box, const std::vector<Ball>& balls) {
  if (balls.size() < 2) return false;
  const Cells cells = cells_over(box, balls);
  const SortedBalls sorted(box, cells, balls);
  if (sorted.pairs(cells.size()) > kMostPairs * balls.size()) return true;
  const Search search(box);
  // Every pair of cells is looked at from the one with the lower number.
  const auto look = [&](std::uint32_t cell, std::uint32_t other) {
    for (std::uint32_t i = sorted.order.begin(cell); i < sorted.order.end(cell); ++i) {
      const std::uint32_t first = cell == other ? i + 1 : sorted.order.begin(other);
      for (std::uint32_t j = first; j < sorted.order.end(other); ++j) {
        if (search.overlap(sorted.balls[i], sorted.balls[j])) return true;
      }
    }
    return false;
  };
  for (std::uint32_t row = 0; row < cells.count(1); ++row) {
    for (std::uint32_t column = 0; column < cells.count(0); ++column) {
      const std::uint32_t cell = cells.number(column, row);
      if (sorted.order.begin(cell) == sorted.order.end(cell)) continue;
      bool found = false;
      cells.each_near(column, row, [&](std::uint32_t other) {
        found = found || (other >= cell && look(cell, other));
      });
      if (found) return true;
    }
  }
  return false;
}

}  // namespace carom::scene
