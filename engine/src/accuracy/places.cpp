#include "accuracy/places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::accuracy {

Places Places::of(const Simulation& simulation) {
  Places places;
  for (const Ball& ball : simulation.state()) {
    places.numbers_.push_back(ball.position.x());
    places.numbers_.push_back(ball.position.y());
  }
  return places;
}

bool Places::finite() const {
  return std::all_of(numbers_.begin(), numbers_.end(), [](double x) { return std::isfinite(x); });
}

double distance(const Places& one, const Places& other, const Box& box) {
  double largest = 0;
  for (std::size_t ball = 0; ball < one.balls(); ++ball) {
    std::array<double, 2> way{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Parts a = one.coordinate(ball, axis);
      const Parts b = other.coordinate(ball, axis);
      way[axis] = difference(a, b);
      if (!box.periodic[axis]) continue;
      const double period = axis == 0 ? box.width : box.height;
      const double turns = std::rint(way[axis] / period);
      // Taken off before it is rounded: a ball at one side and its image at the other are near.
      if (turns != 0) way[axis] = difference(a, b, turns * period);
    }
    const double apart = std::hypot(way[0], way[1]);
    if (!std::isfinite(apart)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, apart);
  }
  return largest;
}

}  // namespace carom::accuracy
