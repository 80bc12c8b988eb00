#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "carom/scene.hpp"
#include "fill/blocked_cells.hpp"
#include "fill/disk_grid.hpp"
#include "fill/equal_disks.hpp"
#include "fill/lattice.hpp"
#include "fill/random.hpp"

namespace carom::scene {

/// Draws places for disks of one radius one after the other, and takes each that has room.
///
/// Several are drawn before the first is tested, so that what memory holds around all of them is
/// fetched at the same time.
/// Holds: what is taken is the same as if each were tested before the next is drawn.
class RandomPlaces {
 public:
  /// For `count` disks that lie wholly in the region.  `before`: the balls that are there, and
  /// `grid` the same.
  RandomPlaces(const Box& box, const Region& region, double radius, std::size_t count,
               const std::vector<Ball>& before, const DiskGrid& grid);

  /// Adds places until there are `count`, or so many have been drawn.
  void draw(Random& random, std::size_t tries, std::vector<Vec2>& places);

 private:
  [[nodiscard]] Vec2 next(Random& random) const;
  [[nodiscard]] bool has_room(const Vec2& place) const;
  void take(const Vec2& place);

  Region region_;
  Region centres_;
  double radius_;
  std::size_t count_;
  const DiskGrid& grid_;
  BlockedCells blocked_;
  std::optional<EqualDisks> taken_;
  DiskGrid far_;  ///< those taken, where coordinates are too large for `taken_`
};

}  // namespace carom::scene
