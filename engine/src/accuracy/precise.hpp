#pragma once

#include <cmath>
#include <span>
#include <vector>

namespace carom::accuracy {

/// A number as an unevaluated sum of doubles, as wide as it needs to be: largest part first.
using Parts = std::span<const double>;

/// a - b - shift, rounded once to double however much of it cancels.
///
/// The sum is kept as parts that do not overlap, each new part being added exactly.
/// Source: Shewchuk, Discrete Comput. Geom. 18 (1997) 305, grow-expansion.
inline double difference(Parts a, Parts b, double shift = 0) {
  if (a.size() == 1 && b.size() == 1 && shift == 0) return a[0] - b[0];
  std::vector<double> sum;  // smallest part first
  const auto add = [&sum](double x) {
    for (double& part : sum) {
      const double whole = x + part;
      const double from_part = whole - x;
      part = (x - (whole - from_part)) + (part - from_part);
      x = whole;
    }
    sum.push_back(x);
  };
  for (const double part : a) add(part);
  for (const double part : b) add(-part);
  add(-shift);
  double result = 0;
  for (const double part : sum) result += part;
  return result;
}

}  // namespace carom::accuracy
