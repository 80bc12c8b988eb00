#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/event/domains/near_lists.hpp"

namespace carom::event {

/// The balls of a domain by the cell of the plane that they are in.
///
/// Balls beyond the ends of an axis that does not wrap are in its outermost cells.
/// Holds: balls no farther apart than the side of a cell are in the same cell or in adjacent ones.
class CellChains {
 public:
  /// Cells of at least `side` over `half` each way from the middle of the domain.
  void reset(const std::array<double, 2>& half, const std::array<double, 2>& periods, double side,
             std::size_t balls) {
    const double most = std::sqrt(static_cast<double>(balls)) * 2 + 8;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double length = 2 * half[axis];
      wraps_[axis] = periods[axis] > 0;
      period_[axis] = periods[axis];
      half_[axis] = half[axis];
      count_[axis] = static_cast<int>(std::clamp(length / side, 1.0, most));
      per_length_[axis] = count_[axis] / length;
    }
    heads_.assign(cells(), kNoSlot);
    links_.resize(balls);
  }

  [[nodiscard]] std::size_t cells() const {
    return static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]);
  }
  [[nodiscard]] int count(std::size_t axis) const { return count_[axis]; }
  [[nodiscard]] bool wraps(std::size_t axis) const { return wraps_[axis]; }
  /// A cell and its neighbours are all different ones.
  [[nodiscard]] bool plain() const {
    return (!wraps_[0] || count_[0] > 2) && (!wraps_[1] || count_[1] > 2);
  }

  [[nodiscard]] std::uint32_t cell_at(double x, double y) const {
    return static_cast<std::uint32_t>(along(1, y) * count_[0] + along(0, x));
  }
  void add(Slot ball, std::uint32_t cell) {
    const Slot next = heads_[cell];
    links_[ball] = {cell, next, kNoSlot};
    if (next != kNoSlot) links_[next].before = ball;
    heads_[cell] = ball;
  }
  void remove(Slot ball) {
    const Link& link = links_[ball];
    if (link.next != kNoSlot) links_[link.next].before = link.before;
    if (link.before != kNoSlot) {
      links_[link.before].next = link.next;
    } else {
      heads_[link.cell] = link.next;
    }
  }
  [[nodiscard]] std::uint32_t cell_of(Slot ball) const { return links_[ball].cell; }

  /// All balls in the cell and those around it, each once.
  template <class Visit>
  void each_near(std::uint32_t cell, const Visit& visit) const {
    const int x = static_cast<int>(cell) % count_[0];
    const int y = static_cast<int>(cell) / count_[0];
    const Range rows = range(1, y);
    const Range columns = range(0, x);
    for (int dy = 0; dy < rows.size; ++dy) {
      const int row = wrapped(1, rows.first + dy) * count_[0];
      for (int dx = 0; dx < columns.size; ++dx) {
        const auto c = static_cast<std::size_t>(row + wrapped(0, columns.first + dx));
        for (Slot k = heads_[c]; k != kNoSlot; k = links_[k].next) visit(k);
      }
    }
  }

  [[nodiscard]] std::size_t bytes() const {
    return heads_.capacity() * sizeof(Slot) + links_.capacity() * sizeof(Link);
  }

 private:
  struct Link {
    std::uint32_t cell = 0;
    Slot next = kNoSlot;
    Slot before = kNoSlot;
  };
  struct Range {
    int first;
    int size;
  };

  [[nodiscard]] int along(std::size_t axis, double x) const {
    if (wraps_[axis]) x -= period_[axis] * std::rint(x / period_[axis]);
    const double cells = (x + half_[axis]) * per_length_[axis];
    return static_cast<int>(std::clamp(cells, 0.0, count_[axis] - 1.0));
  }
  [[nodiscard]] Range range(std::size_t axis, int at) const {
    if (wraps_[axis]) return {at - 1, std::min(3, count_[axis])};
    const int first = std::max(at - 1, 0);
    return {first, std::min(at + 1, count_[axis] - 1) - first + 1};
  }
  [[nodiscard]] int wrapped(std::size_t axis, int at) const {
    return at < 0 ? at + count_[axis] : at >= count_[axis] ? at - count_[axis] : at;
  }

  std::array<int, 2> count_{1, 1};
  std::array<bool, 2> wraps_{};
  std::array<double, 2> period_{};
  std::array<double, 2> half_{};
  std::array<double, 2> per_length_{1, 1};
  std::vector<Slot> heads_;
  std::vector<Link> links_;
};

}  // namespace carom::event
