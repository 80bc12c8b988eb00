#include "accuracy/places.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace carom::accuracy {

double largest_distance(const Places& one, const Places& other, const Box& box) {
  double largest = 0;
  for (std::size_t ball = 0; ball < one.size(); ++ball) {
    const double apart = distance(one[ball], other[ball], box);
    if (!std::isfinite(apart)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, apart);
  }
  return largest;
}

}  // namespace carom::accuracy
