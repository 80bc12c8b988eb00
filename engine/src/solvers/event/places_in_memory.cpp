#include "solvers/event/places_in_memory.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace carom::event {

std::vector<Index> places_in_memory(const Domain& domain, const std::vector<Ball>& balls) {
  const std::size_t n = balls.size();
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), 0U);
  if (n >= kManyBalls) {
    const double area = (domain.upper[0] - domain.lower[0]) * (domain.upper[1] - domain.lower[1]);
    const double block = 8 * std::sqrt(area / static_cast<double>(n));
    std::vector<std::pair<double, double>> place(n);
    for (std::size_t i = 0; i < n; ++i) {
      place[i] = {std::floor(balls[i].position.y() / block),
                  std::floor(balls[i].position.x() / block)};
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return place[a] < place[b]; });
  }
  std::vector<Index> slot(n);
  for (std::size_t k = 0; k < n; ++k) slot[order[k]] = static_cast<Index>(k);
  return slot;
}

}  // namespace carom::event
