#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "carom/scene.hpp"
#include "fill/lattice.hpp"
#include "geometry/cells.hpp"

namespace carom::scene {

/// Many disks of one radius, put down one by one: tells whether another one has room among them.
///
/// Holds: the same answers as a DiskGrid gives.
/// REQUIRES: no coordinate is so large that rounding moves a disk by as much as 2^-10 radii.
class EqualDisks {
 public:
  /// For about `count` disks with their centres in this region.
  EqualDisks(const Box& box, const Region& centres, double radius, std::size_t count);

  void insert(const Vec2& place);
  [[nodiscard]] bool is_free(const Vec2& place) const;

  // What `is_free` reads, fetched ahead, one after the other: the cells, the first disk of each,
  // and the second.
  void fetch_cells(const Vec2& place) const;
  void fetch_first(const Vec2& place) const;
  void fetch_second(const Vec2& place) const;

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  struct Disk {
    double x;
    double y;
    std::uint32_t next;  ///< in the same cell
  };
  /// Calls `visit` with the first disk of each cell around a place that has any.
  template <class Visit>
  void each_head(const Vec2& place, const Visit& visit) const {
    cells_.each_near(cells_.along(0, place.x()), cells_.along(1, place.y()),
                     [&](Cells::Number cell) {
                       if (heads_[cell] != kNone) visit(heads_[cell]);
                     });
  }

  Box box_;
  double radius_;
  std::array<double, 2> same_image_;  ///< nearer along an axis, no way round it is shorter
  Cells cells_;
  std::vector<std::uint32_t> heads_;  ///< by cell
  std::vector<Disk> disks_;
};

}  // namespace carom::scene
