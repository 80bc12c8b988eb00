#pragma once

#include <vector>

#include "carom/scene.hpp"

namespace carom {

/// A position to the last digit it was computed in: each coordinate is the sum of doubles, the
/// largest first.
struct ExactPosition {
  std::vector<double> x;
  std::vector<double> y;
};

/// How far apart two positions are, however little that is; the shorter way round periodic axes.
double distance(const ExactPosition& a, const ExactPosition& b, const Box& box);

}  // namespace carom
