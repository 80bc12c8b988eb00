#pragma once

#include "solvers/event/physics.hpp"

namespace carom::event {

/// The flight of a ball that is at (x, y) at the time 0.
inline Disk flight_at(double x, double y, double vx = 0, double vy = 0, Index species = 0) {
  Disk disk;
  disk.x = x;
  disk.y = y;
  disk.vx = vx;
  disk.vy = vy;
  disk.species = species;
  return disk;
}

}  // namespace carom::event
