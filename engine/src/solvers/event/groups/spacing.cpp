#include "solvers/event/groups/spacing.hpp"

#include <algorithm>
#include <cmath>

namespace carom::event {
namespace {

// A region is wider than a path by so much of the gap between neighbours, and of a diameter.
constexpr double kMarginOfGap = 0.35;
constexpr double kMarginOfDiameter = 0.25;

}  // namespace

Spacing::Spacing(std::size_t balls, double speeds, double diameters, const Domain& domain,
                 const std::array<double, 2>& gravity) {
  const auto n = static_cast<double>(std::max<std::size_t>(balls, 1));
  diameter = diameters / n;
  const double area = (domain.upper[0] - domain.lower[0]) * (domain.upper[1] - domain.lower[1]);
  pitch = std::sqrt(area / n);
  gap = std::max(pitch - diameter, pitch / 16);
  speed = std::sqrt(speeds / n + std::hypot(gravity[0], gravity[1]) * pitch);
}

double Spacing::margin(const std::array<double, 2>& periods) const {
  double margin = kMarginOfDiameter * diameter + kMarginOfGap * gap;
  for (const double period : periods) {
    if (period > 0) margin = std::min(margin, period / 8);
  }
  return margin;
}

}  // namespace carom::event
