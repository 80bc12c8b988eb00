#pragma once

#include <cstdint>

#include "solvers/event/disk.hpp"

namespace carom::event {

/// All that lasts of a ball between two windows: its flight.
struct BlockFlight {
  double x = 0;
  double y = 0;
  double vx = 0;
  double vy = 0;
  FixedTime start = 0;
  Index ball = 0;
  Index species = 0;

  /// The same as what an event loop works with; nothing is known of its end.
  template <class Disk>
  [[nodiscard]] Disk disk() const {
    Disk disk;
    disk.x = x;
    disk.y = y;
    disk.vx = vx;
    disk.vy = vy;
    disk.start = start;
    disk.species = species;
    return disk;
  }
  template <class Disk>
  static BlockFlight of(const Disk& disk, Index ball) {
    return {disk.x, disk.y, disk.vx, disk.vy, disk.start, ball, disk.species};
  }
};
static_assert(sizeof(BlockFlight) == 48);

}  // namespace carom::event
