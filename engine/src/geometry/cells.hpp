#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace carom {

/// A rectangle of the plane in equal cells, numbered row by row from the lower left corner.
///
/// What is beyond an end of an axis that does not wrap counts as in its outermost cell.
class Cells {
 public:
  using Number = std::uint32_t;

  /// Up to three cells of an axis, in rising order where it does not wrap.
  struct Near {
    std::array<Number, 3> at{};
    std::size_t count = 0;
    [[nodiscard]] const Number* begin() const { return at.data(); }
    [[nodiscard]] const Number* end() const { return at.data() + count; }
  };

  /// `count` cells from `lower` over `length`, both lengths; rounded down, and at least one.
  /// REQUIRES: count below 2^32; length >= 0, with one cell where it is 0.
  void divide(std::size_t axis, double lower, double length, double count, bool wraps) {
    Axis& a = axes_[axis];
    a.lower = lower;
    a.count = count >= 2 ? static_cast<Number>(count) : 1;
    a.per_length = length > 0 ? a.count / length : 0;
    a.wraps = wraps;
  }

  [[nodiscard]] std::size_t size() const { return std::size_t{axes_[0].count} * axes_[1].count; }
  [[nodiscard]] Number count(std::size_t axis) const { return axes_[axis].count; }
  [[nodiscard]] bool wraps(std::size_t axis) const { return axes_[axis].wraps; }

  /// The place along an axis of the cell that holds a coordinate.
  [[nodiscard]] Number along(std::size_t axis, double x) const {
    const Axis& a = axes_[axis];
    return static_cast<Number>(std::clamp((x - a.lower) * a.per_length, 0.0, a.count - 1.0));
  }
  [[nodiscard]] Number number(Number column, Number row) const {
    return row * axes_[0].count + column;
  }
  [[nodiscard]] Number at(double x, double y) const { return number(along(0, x), along(1, y)); }
  [[nodiscard]] Number column(Number cell) const { return cell % axes_[0].count; }
  [[nodiscard]] Number row(Number cell) const { return cell / axes_[0].count; }

  /// The cells of an axis that are a place or less from this one, each once.
  [[nodiscard]] Near near(std::size_t axis, Number place) const {
    const Axis& a = axes_[axis];
    // With one or two cells, what lies round the corner is there already.
    const bool round = a.wraps && a.count > 2;
    Near near;
    if (place > 0 || round) near.at[near.count++] = (place > 0 ? place : a.count) - 1;
    near.at[near.count++] = place;
    if (place + 1 < a.count || round) near.at[near.count++] = place + 1 < a.count ? place + 1 : 0;
    return near;
  }
  /// Calls `visit` with the numbers of a cell and of those around it, each once.
  template <class Visit>
  void each_near(Number column, Number row, Visit&& visit) const {
    const Near columns = near(0, column);
    for (const Number r : near(1, row)) {
      for (const Number c : columns) visit(number(c, r));
    }
  }
  template <class Visit>
  void each_near(Number cell, Visit&& visit) const {
    each_near(column(cell), row(cell), visit);
  }

 private:
  struct Axis {
    double lower = 0;
    double per_length = 0;
    Number count = 1;
    bool wraps = false;
  };
  std::array<Axis, 2> axes_;
};

/// Items in the order of their cells; those of one cell keep the order in which they were given.
class ByCell {
 public:
  /// Sorts `count` items, the k-th of which is in the cell `cell_of(k)`: `place(k, at)` is called
  /// for each, with its place in the order.
  template <class CellOf, class Place>
  void sort(std::size_t cells, std::size_t count, CellOf&& cell_of, Place&& place) {
    starts_.assign(cells + 1, 0);
    cell_.resize(count);
    for (std::size_t k = 0; k < count; ++k) ++starts_[cell_[k] = cell_of(k)];
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts_) sum += std::exchange(start, sum);
    for (std::size_t k = 0; k < count; ++k) place(k, starts_[cell_[k]]++);
    // Each start is now the end of its cell, and so the start of the next.
    std::copy_backward(starts_.begin(), starts_.end() - 1, starts_.end());
    starts_[0] = 0;
  }
  [[nodiscard]] std::uint32_t begin(std::size_t cell) const { return starts_[cell]; }
  [[nodiscard]] std::uint32_t end(std::size_t cell) const { return starts_[cell + 1]; }

 private:
  std::vector<std::uint32_t> starts_;  // by cell; one more at the end
  std::vector<std::uint32_t> cell_;    // by item
};

}  // namespace carom
