#pragma once

#include <cmath>
#include <cstddef>

#include "carom/scene.hpp"

namespace carom {

/// A way from one place to another, the shorter way round the periodic axes of the box.
inline Vec2 shorter_way(Vec2 way, const Box& box) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double length = box.size()[axis];
    if (box.periodic[axis]) way[axis] -= length * std::rint(way[axis] / length);
  }
  return way;
}

}  // namespace carom
