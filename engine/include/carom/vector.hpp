#pragma once

#include <Eigen/Core>

namespace carom {

/// A point, velocity or acceleration of the plane: x to the right, y up.
using Vec2 = Eigen::Vector2d;

}  // namespace carom
