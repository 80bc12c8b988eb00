#include "contact/touching.hpp"

#include <algorithm>
#include <cmath>

#include "state/domain.hpp"

namespace carom {
namespace {

constexpr std::size_t kBlock = 64;

template <bool kPeriodicX, bool kPeriodicY>
struct Separation {
  const double* x;
  const double* y;
  double period_x;
  double period_y;

  [[nodiscard]] double along_x(std::int32_t i, std::int32_t j) const {
    const double d = x[j] - x[i];
    return kPeriodicX ? nearest_image(d, period_x) : d;
  }
  [[nodiscard]] double along_y(std::int32_t i, std::int32_t j) const {
    const double d = y[j] - y[i];
    return kPeriodicY ? nearest_image(d, period_y) : d;
  }
};

template <bool kPeriodicX, bool kPeriodicY>
double search(const PairList& pairs, std::size_t begin, std::size_t end, const Balls& balls,
              const std::array<double, 2>& periods, double stretch, std::vector<Pair>& touching) {
  const Separation<kPeriodicX, kPeriodicY> separation{
      balls.position[0].data(), balls.position[1].data(), periods[0], periods[1]};
  const double* radius = balls.radius.data();
  double deepest = 0;
  std::array<double, kBlock> gap;  // between the bounding boxes; no gap where negative
  for (std::size_t start = begin; start < end; start += kBlock) {
    const std::size_t count = std::min(kBlock, end - start);
    const std::int32_t* first = pairs.first.data() + start;
    const std::int32_t* second = pairs.second.data() + start;
    const double* reach = pairs.reach.data() + start;
    for (std::size_t k = 0; k < count; ++k) {
      const double dx = std::abs(separation.along_x(first[k], second[k]));
      const double dy = std::abs(separation.along_y(first[k], second[k]));
      gap[k] = (dx > dy ? dx : dy) - reach[k] * stretch;
    }
    for (std::size_t k = 0; k < count; ++k) {
      if (gap[k] >= 0) continue;
      const double dx = separation.along_x(first[k], second[k]);
      const double dy = separation.along_y(first[k], second[k]);
      const double square = dx * dx + dy * dy;
      const double far = reach[k] * stretch;
      if (square >= far * far) continue;
      touching.push_back(
          {static_cast<std::uint32_t>(first[k]), static_cast<std::uint32_t>(second[k])});
      const double smaller = std::min(radius[first[k]], radius[second[k]]);
      deepest = std::max(deepest, (reach[k] - std::sqrt(square)) / smaller);
    }
  }
  return deepest;
}

}  // namespace

double find_touching(const PairList& pairs, std::size_t begin, std::size_t end, const Balls& balls,
                     const std::array<double, 2>& periods, double stretch,
                     std::vector<Pair>& touching) {
  const bool x = periods[0] > 0;
  const bool y = periods[1] > 0;
  if (x && y) return search<true, true>(pairs, begin, end, balls, periods, stretch, touching);
  if (x) return search<true, false>(pairs, begin, end, balls, periods, stretch, touching);
  if (y) return search<false, true>(pairs, begin, end, balls, periods, stretch, touching);
  return search<false, false>(pairs, begin, end, balls, periods, stretch, touching);
}

}  // namespace carom
