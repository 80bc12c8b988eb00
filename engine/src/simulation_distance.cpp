#include <cmath>

#include "carom/exact_position.hpp"
#include "numbers/exact_sum.hpp"

namespace carom {
namespace {

double difference(const std::vector<double>& a, const std::vector<double>& b, double period) {
  event::ExactSum<double> sum;
  for (const double part : a) sum.add(part);
  for (const double part : b) sum.add(-part);
  const double straight = sum.rounded();
  if (!(period > 0)) return straight;
  const double turns = std::rint(straight / period);
  if (turns == 0) return straight;
  sum.add(-turns * period);
  return sum.rounded();
}

}  // namespace

double distance(const ExactPosition& a, const ExactPosition& b, const Box& box) {
  return std::hypot(difference(a.x, b.x, box.periodic[0] ? box.width : 0),
                    difference(a.y, b.y, box.periodic[1] ? box.height : 0));
}

}  // namespace carom
