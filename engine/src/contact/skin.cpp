#include "contact/skin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

Skin choose_skin(const Balls& balls, const Domain& domain, double step) {
  // Measured costs of building the list for one ball, of one candidate met on the way, and of one
  // pair's test at one step, in units of the last.
  constexpr double kBuild = 11;
  constexpr double kCandidate = 1;
  const auto n = static_cast<double>(balls.size());
  const double area = (domain.upper[0] - domain.lower[0]) * (domain.upper[1] - domain.lower[1]);
  const double density = n / area;
  double radii = 0;
  double widest = 0;
  double fastest_square = 0;
  for (std::size_t i = 0; i < balls.radius.size(); ++i) {
    radii += balls.radius[i];
    widest = std::max(widest, 2 * balls.radius[i]);
    const double vx = balls.velocity[0][i];
    const double vy = balls.velocity[1][i];
    fastest_square = std::max(fastest_square, vx * vx + vy * vy);
  }
  const double diameter = 2 * radii / n;
  const double fastest = std::sqrt(fastest_square);
  double best = diameter / 16;
  double least = std::numeric_limits<double>::infinity();
  for (double skin = diameter / 16; skin <= 2 * diameter; skin *= 1.25) {
    const double steps = std::max(1.0, std::floor(skin / 2 / (fastest * step)));
    const double reach = diameter + skin;
    const double cell = widest + skin;
    const double pairs = density * 3.14 * reach * reach / 2;
    const double candidates = density * 4.5 * cell * cell;
    const double cost = pairs + (kBuild + kCandidate * candidates) / steps;
    if (cost < least) {
      least = cost;
      best = skin;
    }
  }
  return {best, widest + best};
}

}  // namespace carom
