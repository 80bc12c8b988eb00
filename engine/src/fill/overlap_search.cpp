#include "fill/overlap_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "fill/disk_grid.hpp"

namespace carom::scene {

namespace {

/// So much wider than the largest ball is a cell, that rounding moves none beyond the next cell.
constexpr double kWider = 1 + 0x1p-10;
/// Pairs to look at for each ball: with more a DiskGrid is quicker.
constexpr std::uint64_t kMostPairs = 64;

/// What a search needs of a ball, in the order of the cells.
struct Sorted {
  double x = 0;
  double y = 0;
  double radius = 0;
  std::uint32_t ball = 0;
  bool fixed = false;
};

/// Cells of one size over all balls, as wide as the largest ball or wider.
class Cells {
 public:
  Cells(const Box& box, const std::vector<Ball>& balls) : box_(box) {
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
    Vec2 size;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      lower_[axis] = box.periodic[axis] ? box.lower()[axis] : lower[axis];
      size[axis] = box.periodic[axis] ? box.size()[axis] : upper[axis] - lower[axis];
      count[axis] = std::max(1.0, std::floor(size[axis] / (2 * largest * kWider)));
    }
    const double most = 2 * static_cast<double>(balls.size()) + 16;
    while (count[0] * count[1] > most) {
      double& more = count[0] > count[1] ? count[0] : count[1];
      more = std::max(1.0, std::floor(more / 2));
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      count_[axis] = static_cast<std::size_t>(count[axis]);
      per_length_[axis] = size[axis] > 0 ? count[axis] / size[axis] : 0;
    }
  }

  [[nodiscard]] std::size_t size() const { return count_[0] * count_[1]; }
  [[nodiscard]] std::size_t of(const Vec2& position) const {
    return index(1, position) * count_[0] + index(0, position);
  }
  /// The cell so many columns and rows away; none beyond the ends, but round a periodic axis.
  [[nodiscard]] bool beside(std::size_t cell, int columns, int rows, std::size_t& other) const {
    const std::array<int, 2> step{columns, rows};
    std::array<std::size_t, 2> at{cell % count_[0], cell / count_[0]};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (step[axis] == 0) continue;
      const bool at_end = step[axis] > 0 ? at[axis] + 1 == count_[axis] : at[axis] == 0;
      if (at_end && !box_.periodic[axis]) return false;
      if (step[axis] > 0) at[axis] = at_end ? 0 : at[axis] + 1;
      if (step[axis] < 0) at[axis] = at_end ? count_[axis] - 1 : at[axis] - 1;
    }
    other = at[1] * count_[0] + at[0];
    return true;
  }

 private:
  [[nodiscard]] std::size_t index(std::size_t axis, const Vec2& position) const {
    double along = position[axis] - lower_[axis];
    if (box_.periodic[axis]) {
      const double turn = along / box_.size()[axis];
      along = (turn - std::floor(turn)) * box_.size()[axis];
    }
    const auto at = static_cast<std::size_t>(along * per_length_[axis]);
    return std::min(at, count_[axis] - 1);
  }

  const Box& box_;
  Vec2 lower_;
  std::array<std::size_t, 2> count_{1, 1};
  std::array<double, 2> per_length_{0, 0};
};

/// The balls in the order of their cells, and where each cell begins.
struct SortedBalls {
  std::vector<std::uint32_t> begin;
  std::vector<Sorted> balls;

  SortedBalls(const Cells& cells, const std::vector<Ball>& all)
      : begin(cells.size() + 1, 0), balls(all.size()) {
    for (const Ball& ball : all) ++begin[cells.of(ball.position) + 1];
    for (std::size_t cell = 0; cell < cells.size(); ++cell) begin[cell + 1] += begin[cell];
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      const Ball& ball = all[i];
      balls[next[cells.of(ball.position)]++] = {ball.position.x(), ball.position.y(), ball.radius,
                                                i, ball.fixed};
    }
  }

  [[nodiscard]] std::uint64_t pairs() const {
    std::uint64_t sum = 0;
    for (std::size_t cell = 0; cell + 1 < begin.size(); ++cell) {
      const std::uint64_t count = begin[cell + 1] - begin[cell];
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
  const Cells cells(box, balls);
  const SortedBalls sorted(cells, balls);
  if (sorted.pairs() > kMostPairs * balls.size()) return true;
  const Search search(box);
  constexpr std::array<std::array<int, 2>, 4> kForward{{{1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const std::uint32_t end = sorted.begin[cell + 1];
    for (std::uint32_t i = sorted.begin[cell]; i < end; ++i) {
      for (std::uint32_t j = i + 1; j < end; ++j) {
        if (search.overlap(sorted.balls[i], sorted.balls[j])) return true;
      }
    }
    if (sorted.begin[cell] == end) continue;
    for (const auto& [columns, rows] : kForward) {
      std::size_t other = 0;
      if (!cells.beside(cell, columns, rows, other)) continue;
      for (std::uint32_t i = sorted.begin[cell]; i < end; ++i) {
        for (std::uint32_t j = sorted.begin[other]; j < sorted.begin[other + 1]; ++j) {
          if (i != j && search.overlap(sorted.balls[i], sorted.balls[j])) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace carom::scene
