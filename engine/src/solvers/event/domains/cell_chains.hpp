#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/cells.hpp"
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
    periods_ = periods;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double length = 2 * half[axis];
      plane_.divide(axis, -half[axis], length, std::min(length / side, most), periods[axis] > 0);
    }
    heads_.assign(plane_.size(), kNoSlot);
    links_.resize(balls);
  }

  [[nodiscard]] const Cells& plane() const { return plane_; }
  [[nodiscard]] std::size_t cells() const { return plane_.size(); }
  /// A cell and its neighbours are all different ones.
  [[nodiscard]] bool plain() const {
    return (!plane_.wraps(0) || plane_.count(0) > 2) && (!plane_.wraps(1) || plane_.count(1) > 2);
  }

  [[nodiscard]] std::uint32_t cell_at(double x, double y) const {
    return plane_.at(image(0, x), image(1, y));
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
    plane_.each_near(cell, [&](Cells::Number c) {
      for (Slot k = heads_[c]; k != kNoSlot; k = links_[k].next) visit(k);
    });
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

  // The one of its images that is nearest to the middle of the domain.
  [[nodiscard]] double image(std::size_t axis, double x) const {
    return plane_.wraps(axis) ? x - periods_[axis] * std::rint(x / periods_[axis]) : x;
  }

  Cells plane_;
  std::array<double, 2> periods_{};
  std::vector<Slot> heads_;
  std::vector<Link> links_;
};

}  // namespace carom::event
