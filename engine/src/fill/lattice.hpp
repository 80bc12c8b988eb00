#pragma once

#include <cstddef>
#include <vector>

#include "carom/scene.hpp"

namespace carom::scene {

/// Where balls of a fill may be.
struct Region {
  Vec2 lower{0, 0};
  Vec2 upper{0, 0};
  std::array<bool, 2> around{false, false};  ///< goes all around a periodic axis
};

/// Places in even rows over a region.
struct Lattice {
  std::vector<Vec2> sites;  ///< row by row from the lower left
  double spacing = 0;       ///< least distance of two sites, and twice the least one to a side
};

/// The lattice of at least `count` sites whose spacing is the largest.
/// Square: the region is cut into equal columns and rows, a site in the middle of each cell; where
/// the sides have no common measure the cells are nearly square.
Lattice square_lattice(const Region& region, std::size_t count);

/// Hexagonal: every second row is shifted by half a spacing.  All around a periodic axis the rows
/// close on themselves, an even number of them in y.
Lattice hexagonal_lattice(const Region& region, std::size_t count);

}  // namespace carom::scene
